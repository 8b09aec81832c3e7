#pragma once

#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec3.hpp>

#include <cstdint>

/// Walking over the triangles of sheets along straightest paths: straight ahead on every triangle, and over an edge as
/// if both of its triangles lay in one plane (Polthier & Schmies 1998).
namespace hachure::geometry {

/// A place on sheets.
struct WalkPlace {
    std::uint32_t triangle;
    glm::dvec3 weight; ///< of its corners; the sum is 1, none is negative
};

/// A triangle to be walked on.
struct WalkTriangle {
    glm::dvec3 corner[3];
    glm::dvec3 normal{0.0}; ///< unit; 0 when it has no area
    bool flat = false;      ///< it has no area to speak of (is_sliver): there is no walking on it

    WalkTriangle(const SurfaceSheets& sheets, std::uint32_t triangle);

    [[nodiscard]] glm::dvec3 at(const glm::dvec3& weight) const {
        return weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2];
    }
    /// What is left of a vector in the triangle's plane, made unit; 0 when nothing is.
    [[nodiscard]] glm::dvec3 tangent(const glm::dvec3& v) const;
    /// How the weights grow per unit of length along a direction in its plane; 0 on flat triangles.
    [[nodiscard]] glm::dvec3 rates(const glm::dvec3& direction) const;
    /// Unit, in the plane, perpendicular to the edge from corner k to corner k + 1, to the inside.
    [[nodiscard]] glm::dvec3 inward(std::uint32_t k) const;
};

/// What a step on one triangle comes to.
struct WalkStep {
    glm::dvec3 weight; ///< where it ends
    double length;
    std::uint32_t edge; ///< where it leaves the triangle: from corner `edge` on; `inside` when it does not
    static constexpr std::uint32_t inside = 3;
};

/// Goes from `weight` along a unit direction of the triangle's plane, until the rim, until `most` long, or until the
/// next of the lines that divide the triangle into parts * parts alike ones.
[[nodiscard]] WalkStep walk_step(const WalkTriangle& triangle, const glm::dvec3& weight, const glm::dvec3& direction,
                                 double most, std::uint32_t parts = 1);

/// From the edge of the place's triangle that begins at corner `edge` into the triangle behind it; the direction turns
/// with the surface. Triangles without an area are passed over. False where the sheet ends; nothing changes then.
[[nodiscard]] bool cross_edge(const SurfaceSheets& sheets, WalkPlace& place, std::uint32_t& edge,
                              glm::dvec3& direction);

/// The same for who has the place's triangle at hand; it becomes the one behind the edge.
[[nodiscard]] bool cross_edge(const SurfaceSheets& sheets, WalkPlace& place, WalkTriangle& triangle,
                              std::uint32_t& edge, glm::dvec3& direction);

/// Walks straight ahead for `length` as far as the sheet goes and its normal stays within `least_cosine` of `normal`;
/// returns how far it came. `place` and `direction` (unit, a tangent of the place's triangle) move along.
double walk_straight(const SurfaceSheets& sheets, WalkPlace& place, glm::dvec3& direction, double length,
                     const glm::dvec3& normal, double least_cosine);

} // namespace hachure::geometry
