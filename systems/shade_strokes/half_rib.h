#pragma once

#include <hachure/runtime/geometry/surface_walk.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>

#include <glm/vec3.hpp>

namespace hachure {

/// One half of a rib: a line over the surface straight to one side of a chain, as two straight pieces.
struct HalfRib {
    SurfacePoint bend, outer; ///< where the first piece ends, and the second
    double bend_part;         ///< of the way to the outer one, in (0, 1)
    double length;            ///< along the surface, in the mesh's units
    bool ends;                ///< the sheet ends there, or turns away
};

/// What a half rib is to be.
struct HalfRibWish {
    double length;    ///< in the mesh's units
    double deviation; ///< by which its two pieces may be off the surface, in the mesh's units
};

/// Walks straight ahead from a place along `across` (a unit tangent of its triangle) for half a rib. That ends early
/// where the sheet does, where the surface turns by 90 degrees, and where two pieces can't follow the surface any more.
[[nodiscard]] HalfRib walk_half_rib(const ShadeMesh& mesh, const geometry::WalkPlace& from, const glm::dvec3& across,
                                    const HalfRibWish& wish);

} // namespace hachure
