#pragma once

#include <hachure/runtime/geometry/patch_polynomial.h>
#include <hachure/runtime/geometry/vertex_rings.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// Second-order shape of a mesh around a vertex: a polynomial z(x, y) over the vertex's tangent plane, fitted to the
/// vertices around (Cazals & Pouget 2005), and its fundamental forms.
namespace hachure::geometry {

/// Which vertices are fitted with which polynomial.
struct PatchExtent {
    std::size_t degree = 2; ///< 2 or 4
    std::size_t rings = 2;  ///< >= 1; not read where there is a radius
    double radius = 0.0;    ///< metres; 0: rings. Weights fall smoothly to zero there, so that nothing jumps
};

/// What a fit says. The tensor is in the frame of `frame_of(normal)`, positive where the surface bends away from its
/// normal.
struct SurfaceFit {
    double e = 0.0, f = 0.0, g = 0.0; ///< 1/metre: along u, mixed, along v
    double noise = 0.0;               ///< variance of the vertices about the polynomial, metre^2
    double gain = 0.0;                ///< the expected e^2 + 2 f^2 + g^2 of the error, over the variance: metre^-4
    bool quartic = false;             ///< of degree 4
};

/// Memory of one thread.
struct PatchScratch {
    VertexRings rings;
    PatchPoints points;
    PatchPowers powers;
};

/// Fits the vertices that the triangles join to `vertex`, over the plane across the mean normal of its first ring. What
/// turns from that normal by more than 37 degrees counts less, and from 73 degrees on nothing, so that no fold of the
/// surface is taken for its continuation. Where too few vertices are left, at corners of borders and on coarse meshes,
/// a simpler polynomial is fitted, to fewer rings: degree 2; its second-order terms alone; a sphere's. Always finite; 0
/// where nothing is known.
[[nodiscard]] SurfaceFit fit_surface(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                     const VertexNeighbours& neighbours, std::uint32_t vertex,
                                     const PatchExtent& extent, PatchScratch& scratch);

} // namespace hachure::geometry
