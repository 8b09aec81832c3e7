#pragma once

#include <hachure/runtime/assets/model.h>

namespace hachure::assets {

/// Angle between faces, radians, above which computed normals are not shared: a hard edge stays hard.
inline constexpr float computed_normals_crease_angle = 0.87f; // 50 degrees

/// Gives every primitive without normals computed ones: Max's 1999 weights (exact on a sphere, .40 degrees RMS on a
/// torus) over welded positions, split at hard edges, so that a primitive may gain vertices. Faceted models thus keep
/// their facets, as glTF asks for, while finely tessellated ones are smooth.
void complete_normals(Model& model);

} // namespace hachure::assets
