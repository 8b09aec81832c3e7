#pragma once

#include <hachure/runtime/geometry/surface_walk.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>
#include <hachure/systems/shade_strokes/shade_settings.h>

#include <glm/vec3.hpp>

namespace hachure {

/// Half the width of strokes at a place of the rest pose, in the mesh's units, as `stroke_amplitude` has it.
[[nodiscard]] float shade_amplitude(const ShadeMesh& mesh, const ShadeSettings& settings,
                                    const geometry::WalkPlace& place);

/// The node of a chain that runs along `heading` (a unit tangent of the place's triangle): points of the surface to its
/// right and left, found by walking straight across, up to borders and to where the surface turns by 90 degrees.
[[nodiscard]] ShadeNode make_shade_node(const ShadeMesh& mesh, const ShadeSettings& settings,
                                        const geometry::WalkPlace& place, const glm::dvec3& heading, double along);

} // namespace hachure
