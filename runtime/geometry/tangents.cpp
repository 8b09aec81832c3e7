#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/tangents.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace hachure::geometry {
namespace {

/// Side 0 holds the triangles whose texture is seen as in the picture (w = 1), side 1 the mirrored ones (w = -1).
constexpr float handedness[2] = {1.0f, -1.0f};
constexpr std::uint8_t no_side = 2;
constexpr std::uint32_t no_vertex = 0xffffffffu;

/// The unit vector along `v`, or zero where it has no direction.
glm::dvec3 direction(const glm::dvec3& v) {
    const double length = std::sqrt(glm::dot(v, v));
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// The unit vector along the part of `v` in the plane of `normal`; zero where that part is no more than rounding.
glm::dvec3 projected(const glm::dvec3& v, const glm::dvec3& normal) {
    const glm::dvec3 unit = direction(v), flat = unit - normal * glm::dot(normal, unit);
    return glm::dot(flat, flat) > 1e-12 ? direction(flat) : glm::dvec3(0.0);
}

glm::dvec3 perpendicular(const glm::dvec3& normal) {
    const glm::dvec3 a = glm::abs(normal);
    const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                            : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                     : glm::dvec3(0, 0, 1);
    const glm::dvec3 tangent = direction(axis - normal * glm::dot(normal, axis));
    return tangent != glm::dvec3(0.0) ? tangent : axis;
}

/// How a triangle lies in the texture.
struct TexturedTriangle {
    glm::dvec3 u{0.0};           ///< towards growing u, any length
    std::uint8_t side = no_side; ///< no_side when the texture has no area on it
};

class TangentBuilder {
public:
    TangentBuilder(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                   std::span<const glm::vec2> texcoords, std::span<const std::uint32_t> indices)
        : positions_(positions), normals_(normals), texcoords_(texcoords), indices_(indices) {}

    ComputedTangents run() {
        weld_vertices();
        add_triangles();
        emit_vertices();
        return std::move(result_);
    }

private:
    using Sides = std::array<glm::dvec3, 2>;

    [[nodiscard]] auto key(std::uint32_t v) const {
        const glm::vec3 p = positions_[v], n = normals_[v];
        const glm::vec2 t = texcoords_[v];
        return std::tuple(p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y);
    }

    /// Unit as exactly as double has it.
    [[nodiscard]] glm::dvec3 normal(std::uint32_t v) const { return direction(glm::dvec3(normals_[v])); }

    /// Sums are kept at the first of the vertices with the same attributes: how a file shares vertices does not count.
    void weld_vertices() {
        std::vector<std::uint32_t> order(positions_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::uint32_t v) { return std::tuple(key(v), v); });
        weld_.resize(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
            weld_[order[i]] = same ? weld_[order[i - 1]] : order[i];
        }
    }

    /// In double, differences and products of floats are exact: the area in the texture is zero when it is zero.
    [[nodiscard]] TexturedTriangle textured_triangle(std::size_t face) const {
        const std::uint32_t* i = indices_.data() + 3 * face;
        const glm::dvec3 p0(positions_[i[0]]), a(glm::dvec3(positions_[i[1]]) - p0),
            b(glm::dvec3(positions_[i[2]]) - p0);
        const glm::dvec2 t0(texcoords_[i[0]]), s(glm::dvec2(texcoords_[i[1]]) - t0),
            t(glm::dvec2(texcoords_[i[2]]) - t0);
        const double area = s.x * t.y - t.x * s.y; // negative when seen as in the picture, as v grows downwards
        if (!(std::abs(area) > 0.0)) return {};
        const glm::dvec3 u = area > 0.0 ? a * t.y - b * s.y : b * s.y - a * t.y;
        if (u == glm::dvec3(0.0)) return {};
        return {u, static_cast<std::uint8_t>(area > 0.0 ? 1 : 0)};
    }

    void add_triangles() {
        sums_.assign(positions_.size(), Sides{glm::dvec3(0.0), glm::dvec3(0.0)});
        side_.resize(indices_.size() / 3);
        for (std::size_t f = 0; f < side_.size(); ++f) {
            const TexturedTriangle triangle = textured_triangle(f);
            side_[f] = triangle.side;
            if (triangle.side == no_side) continue;
            for (std::size_t k = 0; k < 3; ++k) add_corner(triangle, f, k);
        }
    }

    void add_corner(const TexturedTriangle& triangle, std::size_t face, std::size_t k) {
        const std::uint32_t vertex = indices_[3 * face + k];
        const glm::dvec3 p(positions_[vertex]), n = normal(vertex);
        const auto flat = [&](const glm::dvec3& v) { return projected(v, n); };
        const glm::dvec3 a = flat(glm::dvec3(positions_[indices_[3 * face + (k + 1) % 3]]) - p);
        const glm::dvec3 b = flat(glm::dvec3(positions_[indices_[3 * face + (k + 2) % 3]]) - p);
        const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
        sums_[weld_[vertex]][triangle.side] += angle * flat(triangle.u);
    }

    /// A triangle whose texture has no area goes with what is there.
    [[nodiscard]] std::uint8_t side_at(std::uint32_t vertex, std::uint8_t side) const {
        if (side != no_side) return side;
        const Sides& sums = sums_[weld_[vertex]];
        return sums[0] == glm::dvec3(0.0) && sums[1] != glm::dvec3(0.0) ? 1 : 0;
    }

    /// One vertex for every pair of an input vertex and a side; the first side of a vertex keeps it.
    void emit_vertices() {
        result_.tangents.resize(positions_.size());
        result_.source.resize(positions_.size());
        std::iota(result_.source.begin(), result_.source.end(), 0u);
        result_.indices.resize(indices_.size());
        vertex_of_.assign(positions_.size(), {no_vertex, no_vertex});
        for (std::size_t c = 0; c < indices_.size(); ++c)
            result_.indices[c] = vertex_on(indices_[c], side_at(indices_[c], side_[c / 3]));
        for (std::uint32_t v = 0; v < positions_.size(); ++v)
            if (vertex_of_[v][0] == no_vertex && vertex_of_[v][1] == no_vertex) vertex_on(v, side_at(v, no_side));
    }

    std::uint32_t vertex_on(std::uint32_t source, std::uint8_t side) {
        std::uint32_t& vertex = vertex_of_[source][side];
        if (vertex != no_vertex) return vertex;
        const glm::vec4 tangent = tangent_of(source, side);
        if (vertex_of_[source][1 - side] == no_vertex) {
            vertex = source;
            result_.tangents[vertex] = tangent;
        } else {
            vertex = static_cast<std::uint32_t>(result_.tangents.size());
            result_.tangents.push_back(tangent);
            result_.source.push_back(source);
        }
        return vertex;
    }

    [[nodiscard]] glm::vec4 tangent_of(std::uint32_t vertex, std::uint8_t side) const {
        // Projected again: where tangents nearly cancel, what is left is as large as the rounding of each.
        const glm::dvec3 n = normal(vertex), mean = projected(sums_[weld_[vertex]][side], n);
        return {glm::vec3(mean != glm::dvec3(0.0) ? mean : perpendicular(n)), handedness[side]};
    }

    std::span<const glm::vec3> positions_;
    std::span<const glm::vec3> normals_;
    std::span<const glm::vec2> texcoords_;
    std::span<const std::uint32_t> indices_;
    std::vector<std::uint32_t> weld_;
    std::vector<Sides> sums_;        ///< per vertex, used at those that stand for others
    std::vector<std::uint8_t> side_; ///< per triangle
    std::vector<std::array<std::uint32_t, 2>> vertex_of_;
    ComputedTangents result_;
};

} // namespace

ComputedTangents vertex_tangents(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                 std::span<const glm::vec2> texcoords, std::span<const std::uint32_t> indices) {
    HACHURE_ASSERT(normals.size() == positions.size() && texcoords.size() == positions.size(),
                   "one normal and texture coordinate per vertex");
    HACHURE_ASSERT(indices.size() % 3 == 0 && positions.size() < 0x7fffffffu, "three indices per triangle, in 32 bits");
    HACHURE_ASSERT(std::ranges::all_of(indices, [&](std::uint32_t i) { return i < positions.size(); }),
                   "indices must be in range");
    return TangentBuilder(positions, normals, texcoords, indices).run();
}

} // namespace hachure::geometry
