#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Principal curvatures and directions at the vertices of a mesh that deforms, every frame (Rusinkiewicz 2004: a
/// curvature tensor fitted to the normals of each triangle, averaged at its corners by Voronoi areas). Curvatures are
/// in 1/metre, positive where the surface bends away from its normal: both are 1/r on a sphere of radius r with outward
/// normals. Allocates nothing after the first run on a mesh of that size.
///
/// Borders take the triangles that are there; triangles without an area are left out; a vertex without any triangle
/// has curvatures of zero. Where both curvatures are equal (spheres, planes) every direction is principal, and some
/// unit tangent is given. Never NaN.
struct CurvatureJob {
    std::span<const glm::vec3> positions{};
    /// Unit, one per vertex, as `SmoothNormalsJob` makes them on the same positions and weld. Of vertices at one place,
    /// the normal of the one that stands for them counts.
    std::span<const glm::vec3> normals{};
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    /// Per vertex: the vertex that stands for it, as `weld_positions` gives it for the rest pose, so that seams of
    /// texture coordinates are no borders.
    std::span<const std::uint32_t> weld{};

    std::span<glm::vec2> curvatures{}; ///< out: k1, k2 with |k1| >= |k2|, one per vertex
    std::span<glm::vec3> directions{}; ///< out: unit tangent of k1; that of k2 is cross(normal, direction)

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    struct Sum {
        double area, e, f, g; ///< the tensor's elements in the vertex's frame, each times the area
    };
    std::vector<Sum> sums{};
};

} // namespace hachure::geometry
