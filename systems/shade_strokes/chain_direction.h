#pragma once

#include <hachure/runtime/geometry/surface_walk.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure {

/// Which way a chain runs at a place (section 2.3.3.1): along the interpolated second principal direction, turned by a
/// random disturbance that changes slowly along the chain, the less the truer. Unit, a tangent of the place's triangle,
/// of the sign that agrees with `heading`; `heading` itself where there is no direction.
[[nodiscard]] glm::dvec3 chain_direction(const ShadeMesh& mesh, const geometry::WalkTriangle& triangle,
                                         const geometry::WalkPlace& place, const glm::dvec3& heading, double trueness,
                                         std::uint64_t random, double along);

/// Mirrors a direction that points out of the edge a chain has just come over, which begins at corner `edge`, so that
/// it points into the triangle.
[[nodiscard]] glm::dvec3 mirrored_inside(const geometry::WalkTriangle& triangle, std::uint32_t edge,
                                         const glm::dvec3& direction);

} // namespace hachure
