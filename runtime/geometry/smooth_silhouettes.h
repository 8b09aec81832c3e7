#pragma once

#include <hachure/runtime/geometry/plane_tree.h>
#include <hachure/runtime/geometry/surface_segment.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// The tangent plane at each vertex, dot(n, p) + w = 0, from its position and unit normal. No allocation.
void vertex_planes(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                   std::span<glm::vec4> planes);

/// The silhouette of the smooth surface that a mesh stands for (Hertzmann 1999; Hertzmann & Zorin 2000, section 4):
/// where g = dot(normal, eye - position), linear over each triangle between its vertices, is zero. Lines pass through
/// triangles and go on over their edges, so that a closed mesh has closed lines: no zigzag along its edges.
///
/// A vertex with g = 0 counts as one behind (g < 0), as if it had been moved by less than any number: a triangle that
/// is crossed has one segment, with two different edges under it. An edge's crossing is computed from its lower vertex
/// to its higher. Vertices at one place must have one normal: those of the vertex that stands for them are read.
struct SmoothSilhouettesJob {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> indices; ///< 3 per triangle
    std::span<const std::uint32_t> weld;    ///< per vertex: the one that stands for it, as `weld_positions` gives it
    std::span<const glm::vec4> planes;      ///< of each vertex, as `vertex_planes` gives them from smooth normals
    glm::vec4 eye{0.0f};             ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    const PlaneTree* tree = nullptr; ///< of these planes, as `smooth_silhouette_tree` makes it; without it a plain loop

    /// Out, kept from run to run; by rising faces. Seen along the normal, the front (g > 0) is to the left.
    std::vector<SurfaceSegment> segments{};

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    PlaneTree::Scratch scratch{};       ///< kept from run to run
    std::vector<std::uint32_t> faces{}; ///< scratch: those that the tree found
};

/// The tree for the job: its items are the triangles with three different places.
[[nodiscard]] PlaneTree smooth_silhouette_tree(std::span<const glm::vec4> planes,
                                               std::span<const std::uint32_t> indices,
                                               std::span<const std::uint32_t> weld);

} // namespace hachure::geometry
