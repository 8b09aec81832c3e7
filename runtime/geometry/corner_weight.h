#pragma once

#include <hachure/runtime/geometry/normals.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure::geometry {

/// The weighted normals that a triangle adds to its three corners; zeros when it has no area.
struct CornerNormals {
    glm::dvec3 corner[3];
};

/// Works in double, where products of floats neither round nor underflow, so the scale of a mesh does not matter.
inline CornerNormals corner_normals(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2,
                                    NormalWeight weight) {
    const glm::dvec3 e[3] = {p1 - p0, p2 - p1, p0 - p2}; // e[k] leaves corner k
    const glm::dvec3 n = glm::cross(e[0], e[1]);
    const double n2 = glm::dot(n, n);
    if (!(n2 > 0.0)) return {};
    if (weight == NormalWeight::area) return {{0.5 * n, 0.5 * n, 0.5 * n}};
    if (weight == NormalWeight::max1999) {
        // |a x b| = |n| = |a| |b| sin, so sin / (|a| |b|) times the unit normal is n / (|a|^2 |b|^2).
        const double l[3] = {glm::dot(e[0], e[0]), glm::dot(e[1], e[1]), glm::dot(e[2], e[2])};
        return {{n / (l[0] * l[2]), n / (l[1] * l[0]), n / (l[2] * l[1])}};
    }
    const double length = std::sqrt(n2);
    const glm::dvec3 scaled = weight == NormalWeight::angle ? n / length : 0.5 * n;
    const auto angle = [&](int k) { return std::atan2(length, -glm::dot(e[k], e[(k + 2) % 3])); };
    return {{scaled * angle(0), scaled * angle(1), scaled * angle(2)}};
}

/// The unit vector along `sum`, or `default_normal` where nothing was added or everything cancelled.
inline glm::vec3 normal_of_sum(const glm::dvec3& sum) {
    const double length = std::sqrt(glm::dot(sum, sum));
    return length > 0.0 && std::isfinite(length) ? glm::vec3(sum / length) : default_normal;
}

} // namespace hachure::geometry
