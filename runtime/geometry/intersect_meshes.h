#pragma once

#include <hachure/runtime/geometry/surface_segment.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// The lines along which triangles of a mesh pass through each other. Found once, or again when the mesh deforms; runs
/// on several threads, and its result does not depend on how many.
///
/// All decisions are signs of exact determinants of the given floats, so that they agree between neighbours and lines
/// have no gaps at edges: a line's end lies where an edge pierces a triangle, and all that share it have it bit for
/// bit. A vertex exactly on a triangle's plane counts as behind it: a body that stands on another one, in contact, gets
/// the line along which it stands. Triangles in one plane have no line of their own. Triangles that share two places or
/// more have none; those that share one have a line from there where they pass through each other. Triangles without
/// an area have none.
///
/// `face` and `other_face` of a segment are the two triangles, face < other_face.
[[nodiscard]] std::vector<SurfaceSegment> self_intersections(std::span<const glm::vec3> positions,
                                                             std::span<const std::uint32_t> indices);

/// The lines along which a mesh and another one pass through each other, in the space of the first; `first_from_second`
/// takes the second mesh there (its vertices are rounded to floats there). `face` is of the first mesh, `other_face`
/// of the second.
[[nodiscard]] std::vector<SurfaceSegment> mesh_intersections(std::span<const glm::vec3> positions,
                                                             std::span<const std::uint32_t> indices,
                                                             std::span<const glm::vec3> second_positions,
                                                             std::span<const std::uint32_t> second_indices,
                                                             const glm::mat4& first_from_second = glm::mat4(1.0f));

} // namespace hachure::geometry
