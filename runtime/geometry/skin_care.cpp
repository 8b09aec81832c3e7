#include <hachure/runtime/geometry/skin_arguments.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <initializer_list>

namespace hachure::geometry::skin_loop {
namespace {

glm::dvec3 row(const float* matrix, int r) { return {matrix[4 * r], matrix[4 * r + 1], matrix[4 * r + 2]}; }

glm::dvec3 read(const float* from) { return {from[0], from[1], from[2]}; }

void write(const glm::dvec3& value, float* to) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(value[i]);
}

/// Whether rows mirror, by the stretch along a normal that they stretch to `length`.
bool mirrors(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double length) {
    const double size = glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c);
    const double along = glm::dot(a, glm::cross(b, c)) / length;
    return along < 0.0 && along * along > 1e-12 * size;
}

} // namespace

void careful_normal(const float* matrix, const float* rest, float* out) {
    const glm::dvec3 a = row(matrix, 0), b = row(matrix, 1), c = row(matrix, 2), n = read(rest);
    const glm::dvec3 moved{glm::dot(glm::cross(b, c), n), glm::dot(glm::cross(c, a), n), glm::dot(glm::cross(a, b), n)};
    const double size = glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c), length = glm::length(moved);
    if (!(length > 1e-6 * size && std::isfinite(length))) return write(n, out);
    write((mirrors(a, b, c, length) ? -moved : moved) / length, out);
}

void careful_tangent(const float* matrix, const float* rest, const float* normal, float* out) {
    const glm::dvec3 a = row(matrix, 0), b = row(matrix, 1), c = row(matrix, 2), t = read(rest), n = read(normal);
    const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 moved{glm::dot(a, t), glm::dot(b, t), glm::dot(c, t)};
    // What the matrix makes of it, else the rest pose's, else anything: the first that has a part beside the normal.
    for (const glm::dvec3& candidate : {moved, t, axis}) {
        const glm::dvec3 part = candidate - glm::dot(candidate, n) * n;
        const double length = glm::length(part);
        if (!(length > 1e-3 * glm::length(candidate) && std::isfinite(length))) continue;
        write(part / length, out);
        break;
    }
}

} // namespace hachure::geometry::skin_loop
