#pragma once

#include <hachure/runtime/geometry/skin.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace hachure::test {

/// A cylinder of radius 1 along +Y over a smooth joint: two bones meet at the origin, the upper one is bent about +Z.
/// Over |y| < `zone`, the joint zone, its weight rises from 0 to 1 as a smoothstep. What skinning makes of the surface
/// is known in closed form, in double and without the code under test.
struct BentCylinder {
    static constexpr double zone = 1.5, half_length = 3.0;

    geometry::SkinMethod method = geometry::SkinMethod::linear;
    double angle = 0.0; ///< radians

    /// Of the upper joint at height y.
    [[nodiscard]] static double weight(double y) {
        const double t = std::clamp((y + zone) / (2.0 * zone), 0.0, 1.0);
        return t * t * (3.0 - 2.0 * t);
    }

    /// Angle and length of what the joints' rotations become together at height y: blended matrices shorten, blended
    /// quaternions are made unit.
    struct Turn {
        double c, s;
    };
    [[nodiscard]] Turn turn(double y) const {
        const double w = weight(y);
        if (method == geometry::SkinMethod::linear) return {1.0 - w + w * std::cos(angle), w * std::sin(angle)};
        const double half = std::atan2(w * std::sin(angle / 2.0), 1.0 - w + w * std::cos(angle / 2.0));
        return {std::cos(2.0 * half), std::sin(2.0 * half)};
    }

    /// The deformed surface over longitude and height.
    [[nodiscard]] glm::dvec3 point(double longitude, double y) const {
        const Turn t = turn(y);
        const double x = std::cos(longitude);
        return {t.c * x - t.s * y, t.s * x + t.c * y, std::sin(longitude)};
    }

    /// Normal, curvatures and directions of the deformed surface, through differences in double.
    struct Exact {
        glm::dvec3 normal;       ///< unit, outwards
        double k1, k2;           ///< |k1| >= |k2|, positive where convex
        glm::dvec3 direction[2]; ///< unit tangents of both
    };
    [[nodiscard]] Exact exact(double longitude, double y) const;
};

/// A mesh of that cylinder at rest, without its ends, with what the jobs need to bend it. Vertex numbers run around
/// first; every second triangle of a row is cut the other way, so that no direction is favoured.
struct CylinderMesh {
    std::uint32_t around, along; ///< vertices on a ring, rings (an odd number: one runs between the bones)
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices, weld;
    geometry::SkinWeights weights;
    std::vector<geometry::JointMatrix> palette = std::vector<geometry::JointMatrix>(3);
    std::vector<geometry::JointMotion> motions = std::vector<geometry::JointMotion>(3);

    explicit CylinderMesh(std::uint32_t slices);

    [[nodiscard]] double longitude(std::size_t v) const {
        return 2.0 * std::numbers::pi * static_cast<double>(v % around) / around;
    }
    [[nodiscard]] double height(std::size_t v) const {
        return BentCylinder::half_length * (2.0 * static_cast<double>(v / around) / (along - 1) - 1.0);
    }
    [[nodiscard]] bool in_zone(std::size_t v) const { return std::abs(height(v)) < BentCylinder::zone; }

    /// Poses the upper joint: turned about +Z by `bend` radians, or about +Y by `twist`.
    void pose(double bend, double twist = 0.0);
};

inline CylinderMesh::CylinderMesh(std::uint32_t slices)
    : around(slices),
      along(1 +
            2 * static_cast<std::uint32_t>(std::round(slices * BentCylinder::half_length / (2 * std::numbers::pi)))) {
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> upper;
    for (std::uint32_t v = 0; v < around * along; ++v) {
        const double u = longitude(v), y = height(v), w = BentCylinder::weight(y);
        positions.emplace_back(std::cos(u), y, std::sin(u));
        normals.emplace_back(std::cos(u), 0.0, std::sin(u));
        joints.emplace_back(0, 1, 0, 0);
        upper.emplace_back(1.0 - w, w, 0.0, 0.0);
        weld.push_back(v);
    }
    for (std::uint32_t row = 0; row + 1 < along; ++row)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = row * around + i, b = row * around + (i + 1) % around, c = a + around,
                                d = b + around;
            if ((row + i) % 2 == 0)
                indices.insert(indices.end(), {a, c, b, b, c, d});
            else
                indices.insert(indices.end(), {a, c, d, a, d, b});
        }
    weights = geometry::pack_skin_weights(positions.size(), 2, joints, upper);
}

inline void CylinderMesh::pose(double bend, double twist) {
    glm::dmat4 upper(1.0);
    const double c = std::cos(bend), s = std::sin(bend), ct = std::cos(twist), st = std::sin(twist);
    upper[0] = {c * ct, s * ct, -st, 0.0};
    upper[1] = {-s, c, 0.0, 0.0};
    upper[2] = {c * st, s * st, ct, 0.0};
    palette[1] = geometry::to_joint_matrix(upper);
    motions[1] = geometry::to_joint_motion(upper);
}

inline BentCylinder::Exact BentCylinder::exact(double u, double v) const {
    const double e = 1e-4;
    const auto p = [&](double i, double j) { return point(u + i * e, v + j * e); };
    const glm::dvec3 du = (p(1, 0) - p(-1, 0)) / (2 * e), dv = (p(0, 1) - p(0, -1)) / (2 * e);
    const glm::dvec3 duu = (p(1, 0) - 2.0 * p(0, 0) + p(-1, 0)) / (e * e);
    const glm::dvec3 dvv = (p(0, 1) - 2.0 * p(0, 0) + p(0, -1)) / (e * e);
    const glm::dvec3 duv = (p(1, 1) - p(1, -1) - p(-1, 1) + p(-1, -1)) / (4 * e * e);
    Exact result{};
    result.normal = glm::normalize(glm::cross(dv, du));
    // Roots of det(II - k I) = 0, II being positive where the surface bends away from the normal.
    const double E = glm::dot(du, du), F = glm::dot(du, dv), G = glm::dot(dv, dv);
    const double L = -glm::dot(duu, result.normal), M = -glm::dot(duv, result.normal),
                 N = -glm::dot(dvv, result.normal);
    const double a = E * G - F * F, b = 2.0 * F * M - E * N - G * L, c = L * N - M * M;
    const double root = std::sqrt(std::max(b * b - 4.0 * a * c, 0.0));
    double k[2] = {(-b + root) / (2 * a), (-b - root) / (2 * a)};
    if (std::abs(k[0]) < std::abs(k[1])) std::swap(k[0], k[1]);
    result.k1 = k[0];
    result.k2 = k[1];
    for (int i = 0; i < 2; ++i) {
        // (II - k I) (x, y) = 0, by the row with more to say.
        const double r0[2] = {L - k[i] * E, M - k[i] * F}, r1[2] = {M - k[i] * F, N - k[i] * G};
        const bool first = std::hypot(r0[0], r0[1]) > std::hypot(r1[0], r1[1]);
        const double x = first ? -r0[1] : -r1[1], y = first ? r0[0] : r1[0];
        result.direction[i] = glm::normalize(x * du + y * dv);
    }
    return result;
}

} // namespace hachure::test
