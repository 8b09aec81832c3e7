#pragma once

#include <hachure/runtime/assets/model.h>

namespace hachure::assets {

/// Angle between faces, radians, above which computed normals are not shared: a hard edge stays hard.
inline constexpr float computed_normals_crease_angle = 0.87f; // 50 degrees

/// Gives every primitive without normals computed ones: Max's 1999 weights (exact on a sphere, .40 degrees RMS on a
/// torus) over welded positions, split at hard edges, so that a primitive may gain vertices. Faceted models thus keep
/// their facets, as glTF asks for, while finely tessellated ones are smooth. Tangents of such primitives are dropped.
void complete_normals(Model& model);

/// Gives a primitive without tangents computed ones (geometry::vertex_tangents) for a normal map that is used so, when
/// it has that set of texture coordinates; it may gain vertices. Computed tangents follow the map as its transform
/// turns it; a file's are taken as made for what is seen, as glTF viewers do.
void complete_tangents(Primitive& primitive, const TextureUse& normal_map);

} // namespace hachure::assets
