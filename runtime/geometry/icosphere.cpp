#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace hachure::geometry {
namespace {

using Facet = std::array<std::uint32_t, 3>;

struct Sphere {
    std::vector<glm::dvec3> points; ///< unit
    std::vector<Facet> triangles;
};

Sphere icosahedron() {
    constexpr double t = std::numbers::phi;
    Sphere sphere{{{-1, t, 0},
                   {1, t, 0},
                   {-1, -t, 0},
                   {1, -t, 0},
                   {0, -1, t},
                   {0, 1, t},
                   {0, -1, -t},
                   {0, 1, -t},
                   {t, 0, -1},
                   {t, 0, 1},
                   {-t, 0, -1},
                   {-t, 0, 1}},
                  {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (glm::dvec3& p : sphere.points) p = glm::normalize(p);
    return sphere;
}

/// Cuts every triangle into four.
void subdivide(Sphere& sphere) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(sphere.points.size()));
        if (is_new) sphere.points.push_back(glm::normalize(sphere.points[a] + sphere.points[b]));
        return at->second;
    };
    std::vector<Facet> finer;
    for (const auto& [a, b, c] : sphere.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Facet& t : {Facet{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}) finer.push_back(t);
    }
    sphere.triangles = std::move(finer);
}

} // namespace

Shape icosphere(double radius, std::uint32_t level) {
    HACHURE_ASSERT(level <= 8, "more than 1.3 million triangles is no fixture");
    Sphere sphere = icosahedron();
    for (std::uint32_t i = 0; i < level; ++i) subdivide(sphere);
    Shape shape;
    for (const glm::dvec3& n : sphere.points) {
        const double turns = std::atan2(-n.z, n.x) / (2.0 * std::numbers::pi);
        shape.positions.emplace_back(radius * n);
        shape.normals.emplace_back(n);
        shape.texcoords.emplace_back(turns < 0.0 ? turns + 1.0 : turns, 0.5 + std::asin(n.y) / std::numbers::pi);
    }
    for (const Facet& t : sphere.triangles) shape.indices.insert(shape.indices.end(), t.begin(), t.end());
    return shape;
}

} // namespace hachure::geometry
