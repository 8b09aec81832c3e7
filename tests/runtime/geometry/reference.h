#pragma once

#include <hachure/runtime/geometry/shapes.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

/// Slow and plain counterparts of the code under test.
namespace hachure::geometry::reference {

inline glm::dvec3 area_normal(std::span<const glm::vec3> p, std::span<const std::uint32_t> i, std::size_t face) {
    const glm::dvec3 a(p[i[3 * face]]), b(p[i[3 * face + 1]]), c(p[i[3 * face + 2]]);
    return 0.5 * glm::cross(b - a, c - a);
}

inline double area(std::span<const glm::vec3> p, std::span<const std::uint32_t> i) {
    double sum = 0.0;
    for (std::size_t f = 0; f < i.size() / 3; ++f) sum += glm::length(area_normal(p, i, f));
    return sum;
}

/// Signed, by the divergence theorem.
inline double volume(std::span<const glm::vec3> p, std::span<const std::uint32_t> i) {
    double sum = 0.0;
    for (std::size_t f = 0; f < i.size() / 3; ++f) sum += glm::dot(glm::dvec3(p[i[3 * f]]), area_normal(p, i, f)) / 3.0;
    return sum;
}

using PlaceLess = decltype([](const glm::vec3& a, const glm::vec3& b) {
    return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
});

/// First vertex at each vertex's place, through an ordered map.
inline std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions) {
    std::map<glm::vec3, std::uint32_t, PlaceLess> first;
    std::vector<std::uint32_t> result;
    for (std::uint32_t v = 0; v < positions.size(); ++v) result.push_back(first.emplace(positions[v], v).first->second);
    return result;
}

/// Triangles at each edge, with the direction in which they run along it, no triangle left out.
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, bool>>>;
inline Edges edges(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    const std::vector<std::uint32_t> place = weld(positions);
    Edges result;
    for (std::uint32_t c = 0; c < indices.size(); ++c) {
        const std::uint32_t a = place[indices[c]], b = place[indices[c % 3 == 2 ? c - 2 : c + 1]];
        result[{std::min(a, b), std::max(a, b)}].emplace_back(c / 3, a < b);
    }
    return result;
}

/// Root mean square of the angle between two lists of unit vectors, degrees.
inline double rms_degrees(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::dvec3 u(a[i]), v(b[i]);
        const double angle = std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
        sum += angle * angle;
    }
    return std::sqrt(sum / static_cast<double>(a.size())) * 57.29577951308232;
}

} // namespace hachure::geometry::reference
