#pragma once

#include <hachure/runtime/assets/gltf_json.h>

#include <cstddef>

namespace hachure::assets {

/// Lengths of a document's arrays: what its indices may point into.
struct GltfCounts {
    std::size_t accessors = 0, buffers = 0, buffer_views = 0, cameras = 0, images = 0, lights = 0, materials = 0;
    std::size_t meshes = 0, nodes = 0, samplers = 0, scenes = 0, skins = 0, textures = 0;
};

/// The part of `check_gltf` that is about buffers and what is made of them: buffers, views, accessors, meshes, skins
/// and animations.
void check_gltf_data(const JsonPlace& root, const GltfCounts& counts);

} // namespace hachure::assets
