#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

namespace hachure {

/// One mesh of the primitives, each a submesh: edge lines and other methods see a surface whole, whatever materials cut
/// it up. Attributes that only some primitives have get neutral values in the others (white, texture coordinate 0).
/// The first set of texture coordinates is taken for the base colour's, a second one for the normal map's, which is
/// left out where the primitive has no tangents. `material` gives the surface material for a primitive's index into
/// Model::materials; `joint_count` is the number of joints that the mesh is skinned with, 0 for none. The mesh has all
/// morph targets of the primitives.
[[nodiscard]] SurfaceMesh merge_primitives(std::string_view name, std::span<const assets::Primitive> primitives,
                                           const std::function<SurfaceMaterial(std::int32_t)>& material,
                                           std::size_t joint_count = 0);

} // namespace hachure
