#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/blended_joint.h>
#include <hachure/runtime/geometry/principal.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/geometry/vertex_range.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure::geometry {
namespace {

struct Carried {
    glm::dvec2 curvatures;
    glm::dvec3 direction;
};

/// The second fundamental form of a surface under a linear map: II'(m u) = |det m| / |cof(m) n| II(u), for the normal
/// that keeps pointing outwards; the metric changes with the lengths of m u. In the basis (a, normal x a) of the mapped
/// directions a = m d1 = (p, 0) and b = m d2 = (q, r), II' is P^-T diag P^-1 with P = (p q; 0 r).
Carried carry(const glm::dmat3& m, const glm::dvec3& normal, const glm::dvec3& direction, const glm::dvec2& k) {
    const glm::dvec3 a = m * direction, b = m * glm::cross(normal, direction), moved = glm::cross(a, b);
    const double size = glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]), area = glm::length(moved);
    if (!(area > 1e-6 * size)) return {k, direction}; // a collapse: the normal, too, is the rest pose's
    const double p = glm::length(a), q = glm::dot(a, b) / p, r = area / p;
    const double factor = std::abs(glm::dot(moved, m * normal)) / area;
    const double e = factor * k.x / (p * p), f = -e * q / r, g = -f * q / r + factor * k.y / (r * r);
    const Principal result = principal(e, f, g);
    if (!std::isfinite(result.k1) || !std::isfinite(result.k2)) return {{0.0, 0.0}, a / p};
    const glm::dvec3 x = a / p, y = glm::cross(moved / area, x);
    return {{result.k1, result.k2}, glm::normalize(result.x * x + result.y * y)};
}

} // namespace

void CarryCurvatureJob::validate() const {
    const std::size_t count = rest_normals.size();
    HACHURE_ASSERT(weights != nullptr && weights->vertex_count() == count, "weights of every vertex");
    HACHURE_ASSERT(rest_curvatures.size() == count && rest_directions.size() == count, "one element per vertex");
    HACHURE_ASSERT(curvatures.size() == count && directions.size() == count, "one element per vertex");
    const std::size_t entries = method == SkinMethod::linear ? palette.size() : motions.size();
    HACHURE_ASSERT(entries == weights->palette_size(), "a palette entry per joint and one more");
}

void CarryCurvatureJob::run() {
    const std::size_t end = end_of(range, rest_normals.size());
    for (std::size_t v = range.first; v < end; ++v) {
        const glm::dmat3 m =
            method == SkinMethod::linear ? blended_matrix(*weights, palette, v) : blended_motion(*weights, motions, v);
        const Carried carried =
            carry(m, glm::dvec3(rest_normals[v]), glm::dvec3(rest_directions[v]), glm::dvec2(rest_curvatures[v]));
        curvatures[v] = carried.curvatures;
        directions[v] = carried.direction;
    }
}

} // namespace hachure::geometry
