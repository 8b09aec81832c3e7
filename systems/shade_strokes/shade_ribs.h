#pragma once

#include <hachure/runtime/geometry/surface_walk.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>
#include <hachure/systems/shade_strokes/shade_settings.h>

#include <glm/vec3.hpp>

namespace hachure {

/// Half the width of strokes at a place, in the mesh's units: the radius of the first principal curvature as far as the
/// settings ask for that (section 2.3.3.1: "the inverse of the interpolated curvature"), within their limits, which
/// hold on planes. Always finite.
[[nodiscard]] float shade_amplitude(const ShadeMesh& mesh, const ShadeSettings& settings,
                                    const geometry::WalkPlace& place);

/// A node of a chain, and what is known of its rib where it is laid.
struct ShadeRib {
    ShadeNode node;
    bool ends[2]; ///< whether the sheet ends, or turns away, at the end of the right and of the left half
};

/// The node of a chain that runs along `heading` (a unit tangent of the place's triangle): points of the surface to its
/// right and left, found by walking straight across, as far as two straight pieces follow the surface.
[[nodiscard]] ShadeRib make_shade_rib(const ShadeMesh& mesh, const ShadeSettings& settings,
                                      const geometry::WalkPlace& place, const glm::dvec3& heading, double along);

/// How far the patch between two nodes is off the surface along a rib that lies `part` of the way between them, in the
/// mesh's units: across the surface at the rib's points, and beyond its ends where the sheet has one.
[[nodiscard]] double patch_deviation(const ShadeMesh& mesh, const ShadeNode& from, const ShadeNode& to,
                                     const ShadeRib& between, double part);

} // namespace hachure
