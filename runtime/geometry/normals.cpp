#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/corner_weight.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/topology.h>
#include <hachure/runtime/geometry/weld.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace hachure::geometry {
namespace {

/// Splits the corners around every place into groups that share a normal.
class CreaseSplitter {
public:
    CreaseSplitter(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                   const NormalOptions& options)
        : positions_(positions), indices_(indices), weld_(weld_positions(positions)),
          // The margin keeps triangles of one plane together, whose normals differ by rounding.
          min_cosine_(std::cos(static_cast<double>(options.crease_angle)) - 1e-9), group_of_(indices.size()) {
        std::iota(group_of_.begin(), group_of_.end(), 0u);
        compute_triangles(options.weight);
        sort_corners_by_place();
    }

    ComputedNormals run() {
        result_.normals.assign(positions_.size(), glm::vec3(0.0f));
        result_.source.resize(positions_.size());
        std::iota(result_.source.begin(), result_.source.end(), 0u);
        result_.indices.assign(indices_.begin(), indices_.end());
        for (std::size_t v = 0; v < positions_.size(); ++v) {
            const std::span corners(corners_.data() + first_[v], first_[v + 1] - first_[v]);
            if (corners.empty()) continue;
            join_across_smooth_edges(corners);
            emit_vertices(corners);
        }
        fill_unused_vertices();
        return std::move(result_);
    }

private:
    void compute_triangles(NormalWeight weight) {
        weighted_.resize(indices_.size());
        unit_.resize(indices_.size() / 3);
        for (std::size_t f = 0; f < unit_.size(); ++f) {
            const glm::dvec3 p0(positions_[indices_[3 * f]]), p1(positions_[indices_[3 * f + 1]]),
                p2(positions_[indices_[3 * f + 2]]);
            const CornerNormals n = corner_normals(p0, p1, p2, weight);
            std::copy_n(n.corner, 3, weighted_.begin() + static_cast<std::ptrdiff_t>(3 * f));
            const glm::dvec3 cross = glm::cross(p1 - p0, p2 - p0);
            const double length = std::sqrt(glm::dot(cross, cross));
            unit_[f] = length > 0.0 ? cross / length : glm::dvec3(0.0);
        }
    }

    [[nodiscard]] bool has_area(std::size_t face) const { return unit_[face] != glm::dvec3(0.0); }
    [[nodiscard]] std::uint32_t place(std::uint32_t corner) const { return weld_[indices_[corner]]; }

    /// Corners of triangles with an area, in order, behind the start of their place.
    void sort_corners_by_place() {
        first_.assign(positions_.size() + 1, 0);
        for (std::uint32_t c = 0; c < indices_.size(); ++c)
            if (has_area(c / 3)) ++first_[place(c) + 1];
        for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
        corners_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t c = 0; c < indices_.size(); ++c)
            if (has_area(c / 3)) corners_[next[place(c)]++] = c;
    }

    std::uint32_t group(std::uint32_t corner) {
        while (group_of_[corner] != corner) corner = group_of_[corner] = group_of_[group_of_[corner]];
        return corner;
    }

    void join_if_smooth(std::uint32_t a, std::uint32_t b) {
        if (glm::dot(unit_[a / 3], unit_[b / 3]) < min_cosine_) return;
        a = group(a);
        b = group(b);
        group_of_[std::max(a, b)] = std::min(a, b);
    }

    void join_across_smooth_edges(std::span<const std::uint32_t> corners) {
        spokes_.clear();
        for (const std::uint32_t c : corners) {
            spokes_.push_back({place(c % 3 == 2 ? c - 2 : c + 1), c});
            spokes_.push_back({place(c % 3 == 0 ? c + 2 : c - 1), c});
        }
        std::ranges::sort(spokes_);
        // Where many triangles meet on one edge, comparing each with a few that follow bounds the work.
        constexpr std::size_t compared = 8;
        for (std::size_t i = 0; i < spokes_.size(); ++i)
            for (std::size_t j = i + 1; j < spokes_.size() && j <= i + compared; ++j)
                if (spokes_[i].first == spokes_[j].first) join_if_smooth(spokes_[i].second, spokes_[j].second);
    }

    /// One vertex for every pair of an input vertex at this place and a group; the first group of a vertex keeps it.
    void emit_vertices(std::span<const std::uint32_t> corners) {
        uses_.clear();
        for (const std::uint32_t c : corners) {
            const std::uint32_t root = group(c);
            if (root != c) weighted_[root] += weighted_[c]; // roots are the lowest corners: they come first
            uses_.push_back({indices_[c], root, c});
        }
        std::ranges::sort(uses_);
        std::uint32_t vertex = 0;
        for (std::size_t i = 0; i < uses_.size(); ++i) {
            const auto [original, root, corner] = uses_[i];
            if (i == 0 || original != std::get<0>(uses_[i - 1])) {
                vertex = original;
                result_.normals[vertex] = normal_of_sum(weighted_[root]);
            } else if (root != std::get<1>(uses_[i - 1])) {
                vertex = static_cast<std::uint32_t>(result_.normals.size());
                result_.normals.push_back(normal_of_sum(weighted_[root]));
                result_.source.push_back(original);
            }
            result_.indices[corner] = vertex;
        }
    }

    /// Vertices of triangles without an area take a normal of their place; isolated ones the default.
    void fill_unused_vertices() {
        for (std::size_t v = 0; v < positions_.size(); ++v) {
            if (result_.normals[v] != glm::vec3(0.0f)) continue;
            const std::size_t p = weld_[v];
            result_.normals[v] =
                first_[p] < first_[p + 1] ? normal_of_sum(weighted_[group(corners_[first_[p]])]) : default_normal;
        }
    }

    using VertexUse = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>; // input vertex, group, corner
    std::span<const glm::vec3> positions_;
    std::span<const std::uint32_t> indices_;
    std::vector<std::uint32_t> weld_;
    double min_cosine_;
    std::vector<std::uint32_t> group_of_; ///< corner -> towards the root of its group
    std::vector<glm::dvec3> weighted_;    ///< per corner; at a root, the sum of its group
    std::vector<glm::dvec3> unit_;        ///< per triangle, zero without an area
    std::vector<std::size_t> first_;      ///< per place, into corners_
    std::vector<std::uint32_t> corners_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes_; ///< place at the other end of an edge, corner
    std::vector<VertexUse> uses_;
    ComputedNormals result_;
};

ComputedNormals smooth_everywhere(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                  NormalWeight weight) {
    ComputedNormals result{std::vector<glm::vec3>(positions.size()),
                           std::vector<std::uint32_t>(positions.size()),
                           {indices.begin(), indices.end()}};
    std::iota(result.source.begin(), result.source.end(), 0u);
    const std::vector<std::uint32_t> weld = weld_positions(positions);
    SmoothNormalsJob job{positions, indices, weld, weight, result.normals};
    job.validate();
    job.run();
    return result;
}

} // namespace

ComputedNormals vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               const NormalOptions& options) {
    HACHURE_ASSERT(indices.size() % 3 == 0 && indices.size() < 0xffffffffu, "three indices per triangle, in 32 bits");
    HACHURE_ASSERT(std::ranges::all_of(indices, [&](std::uint32_t i) { return i < positions.size(); }),
                   "indices must be in range");
    if (options.crease_angle >= std::numbers::pi_v<float>) return smooth_everywhere(positions, indices, options.weight);
    return CreaseSplitter(positions, indices, options).run();
}

} // namespace hachure::geometry
