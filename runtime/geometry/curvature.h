#pragma once

#include <hachure/runtime/geometry/curvature_fits.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// What curvatures are taken from. docs/curvature.md has the errors and costs of each.
enum class CurvatureMethod : std::uint8_t {
    one_ring,  ///< the normals of the triangles around a vertex (Rusinkiewicz 2004); one thread
    quadric,   ///< a polynomial of degree 2, fitted to 2 rings of vertices
    quartic,   ///< a polynomial of degree 4, fitted to 3 rings of vertices: exact where the mesh is
    automatic, ///< degree 4 on as many rings as the noise that is found in the mesh asks for, 3 to 12
};

/// Principal curvatures and directions at the vertices of a mesh that deforms, every frame. Curvatures are in 1/metre,
/// positive where the surface bends away from its normal: both are 1/r on a sphere of radius r with outward normals.
/// Allocates nothing after the first run on a mesh of that size; `automatic` may once more, when it meets noise for the
/// first time. Results do not depend on the number of threads.
///
/// `one_ring` fits a tensor to the normals of each triangle and averages them at its corners by Voronoi areas; borders
/// take the triangles that are there, triangles without an area are left out. The other methods fit the vertices that
/// edges lead to (surface_patch.h), and see of triangles only which vertices they join, however many meet at an edge;
/// where too few vertices are left, they fit a simpler surface.
///
/// A vertex without any triangle has curvatures of zero. Where both curvatures are equal (spheres, planes) every
/// direction is principal, and some unit tangent is given: `confidences` tell, and FillDirectionsJob makes a smooth
/// field of what is left. Never NaN.
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
    /// Out, one per vertex, or none: how much there is to the direction, in [0, 1], by the difference of the
    /// curvatures' sizes and, where a polynomial is fitted, by its expected error.
    std::span<float> confidences{};

    CurvatureMethod method = CurvatureMethod::one_ring;
    std::uint32_t rings = 0; ///< of quadric and quartic; 0: 2 and 3
    double radius = 0.0;     ///< metres: quadric and quartic take the vertices so near instead of rings; 0: rings
    /// Of automatic: an error, over the size of the curvature, that is small enough not to look at more vertices.
    double tolerance = 0.03;
    /// Of `indices` and `weld`, for meshes that keep their topology; otherwise found by each run that needs it.
    const VertexNeighbours* neighbours = nullptr;

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    struct Sum {
        double area, e, f, g; ///< the tensor's elements in the vertex's frame, each times the area
    };
    std::vector<Sum> sums{};
    CurvatureFits fits{};
    VertexNeighbours own_neighbours{}; ///< where none are given
};

} // namespace hachure::geometry
