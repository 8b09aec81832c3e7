#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/box_tree.h>
#include <hachure/runtime/geometry/intersect_meshes.h>
#include <hachure/runtime/geometry/topology.h>
#include <hachure/runtime/geometry/triangle_pair.h>
#include <hachure/runtime/parallel.h>

#include <algorithm>
#include <cstddef>

namespace hachure::geometry {
namespace {

/// The triangles of a mesh with what their intersections need.
class Triangles {
public:
    /// Places count from `first_place` on, edges from `first_edge` on, so that two meshes have none in common.
    Triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, std::uint32_t first_place,
              std::uint32_t first_edge)
        : positions_(positions), first_place_(first_place), first_edge_(first_edge),
          welded_(weld_triangles(positions, indices, Backs::keep)), edges_(indices.size(), 0),
          boxes_(indices.size() / 3) {
        EdgeUses(welded_).each_edge([&](std::uint32_t, std::span<const EdgeUse> uses) {
            for (const EdgeUse& use : uses) edges_[use.corner] = uses[0].corner;
        });
        for (std::size_t face = 0; face < boxes_.size(); ++face)
            if (welded_.kept(face))
                for (const std::uint32_t place : welded_.corners[face]) boxes_[face].include(positions[place]);
    }

    [[nodiscard]] std::span<const Bounds> boxes() const { return boxes_; }

    [[nodiscard]] PlacedTriangle operator[](std::uint32_t face) const {
        PlacedTriangle triangle{};
        triangle.face = face;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t place = welded_.corners[face][k];
            triangle.position[k] = positions_[place];
            triangle.place[k] = first_place_ + place;
            triangle.edge[k] = first_edge_ + edges_[3 * face + k];
        }
        return triangle;
    }

private:
    std::span<const glm::vec3> positions_;
    std::uint32_t first_place_, first_edge_;
    WeldedTriangles welded_;
    std::vector<std::uint32_t> edges_; ///< per corner: the first corner of the mesh with the edge that begins here
    std::vector<Bounds> boxes_;        ///< per triangle; empty where it is left out
};

/// All intersections of triangles of `first` with those of `second` that the tree holds; with later ones of the same
/// mesh where both are one.
std::vector<SurfaceSegment> intersections(const Triangles& first, const Triangles& second) {
    const BoxTree tree(second.boxes());
    const bool self = &first == &second;
    constexpr std::size_t chunk = 512;
    const std::size_t count = first.boxes().size(), tasks = (count + chunk - 1) / chunk;
    std::vector<std::vector<SurfaceSegment>> found(tasks);
    parallel_for(tasks, [&](std::size_t task) {
        std::vector<std::uint32_t> others;
        for (std::size_t f = task * chunk; f < std::min(count, (task + 1) * chunk); ++f) {
            const Bounds& box = first.boxes()[f];
            if (box.empty()) continue;
            const auto face = static_cast<std::uint32_t>(f);
            others.clear();
            tree.each_touching(box, self ? face + 1 : 0, [&](std::uint32_t other) { others.push_back(other); });
            std::ranges::sort(others);
            const PlacedTriangle triangle = first[face];
            for (const std::uint32_t other : others)
                if (const auto segment = intersection(triangle, second[other])) found[task].push_back(*segment);
        }
    });
    std::vector<SurfaceSegment> segments;
    for (const std::vector<SurfaceSegment>& part : found) segments.insert(segments.end(), part.begin(), part.end());
    return segments;
}

} // namespace

std::vector<SurfaceSegment> self_intersections(std::span<const glm::vec3> positions,
                                               std::span<const std::uint32_t> indices) {
    HACHURE_ASSERT(indices.size() < (std::size_t{1} << 31), "edges are counted in 31 bits");
    const Triangles triangles(positions, indices, 0, 0);
    return intersections(triangles, triangles);
}

std::vector<SurfaceSegment> mesh_intersections(std::span<const glm::vec3> positions,
                                               std::span<const std::uint32_t> indices,
                                               std::span<const glm::vec3> second_positions,
                                               std::span<const std::uint32_t> second_indices,
                                               const glm::mat4& first_from_second) {
    HACHURE_ASSERT(indices.size() + second_indices.size() < (std::size_t{1} << 31), "edges are counted in 31 bits");
    const glm::dmat4 matrix(first_from_second);
    std::vector<glm::vec3> moved;
    moved.reserve(second_positions.size());
    for (const glm::vec3& p : second_positions) moved.emplace_back(matrix * glm::dvec4(p, 1.0));
    const Triangles first(positions, indices, 0, 0);
    const Triangles second(moved, second_indices, static_cast<std::uint32_t>(positions.size()),
                           static_cast<std::uint32_t>(indices.size()));
    return intersections(first, second);
}

} // namespace hachure::geometry
