#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

/// What fitting tensors to triangles needs; shared by curvature and its derivative.
namespace hachure::geometry {

/// Two unit vectors perpendicular to a unit normal and to each other: a function of the normal alone, so that frames
/// need not be stored (Duff et al. 2017).
struct Frame {
    glm::dvec3 u, v;
};

[[nodiscard]] inline Frame frame_of(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// The frame of a plane with one unit normal turned into the plane with another about the line where they meet, so that
/// nothing is lost to the angle between them.
[[nodiscard]] inline Frame turned(Frame frame, const glm::dvec3& from, const glm::dvec3& to) {
    const double cosine = glm::dot(from, to);
    if (!(cosine > -1.0 + 1e-9)) return {-frame.u, -frame.v};
    const glm::dvec3 across = to - cosine * from, turn = (to + from) / (1.0 + cosine);
    frame.u -= turn * glm::dot(frame.u, across);
    frame.v -= turn * glm::dot(frame.v, across);
    return frame;
}

/// One triangle: edge k lies opposite corner k.
struct Triangle {
    glm::dvec3 edge[3], normal; ///< the normal is unit
    double square[3], area;     ///< squared lengths of the edges
};

/// Whether the triangle has a normal to be trusted: one with a height under 1e-6 of its longest edge has not.
[[nodiscard]] inline bool measure(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2,
                                  Triangle& triangle) {
    triangle.edge[0] = p2 - p1;
    triangle.edge[1] = p0 - p2;
    triangle.edge[2] = p1 - p0;
    for (int k = 0; k < 3; ++k) triangle.square[k] = glm::dot(triangle.edge[k], triangle.edge[k]);
    const glm::dvec3 cross = glm::cross(triangle.edge[0], triangle.edge[1]);
    const double length = glm::length(cross);
    if (!(length > 1e-6 * std::max({triangle.square[0], triangle.square[1], triangle.square[2]}))) return false;
    triangle.normal = cross / length;
    triangle.area = 0.5 * length;
    return true;
}

/// The part of the triangle's area nearest to each corner (Meyer et al. 2003): Voronoi, and where the triangle is
/// obtuse what stays inside it.
inline void corner_areas(const Triangle& t, double (&areas)[3]) {
    const double* l = t.square;
    const double w[3] = {l[0] * (l[1] + l[2] - l[0]), l[1] * (l[2] + l[0] - l[1]), l[2] * (l[0] + l[1] - l[2])};
    for (int k = 0; k < 3; ++k) {
        if (w[k] > 0.0) continue; // obtuse at corner k, or right-angled
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        areas[i] = -0.25 * l[j] * t.area / glm::dot(t.edge[k], t.edge[j]);
        areas[j] = -0.25 * l[i] * t.area / glm::dot(t.edge[k], t.edge[i]);
        areas[k] = t.area - areas[i] - areas[j];
        return;
    }
    const double scale = 0.5 * t.area / (w[0] + w[1] + w[2]);
    for (int k = 0; k < 3; ++k) areas[k] = scale * (w[(k + 1) % 3] + w[(k + 2) % 3]);
}

} // namespace hachure::geometry
