#pragma once

#include <hachure/runtime/assets/model.h>

#include <cstdint>

namespace hachure::assets {

/// Where the parts of one model begin in another that they were appended to.
struct ModelPlaces {
    std::int32_t meshes = 0, materials = 0;                                     ///< by append_resources
    std::int32_t nodes = 0, cameras = 0, lights = 0, skins = 0, animations = 0; ///< by append_instance
};

/// Appends what instances of `source` share: meshes, materials, textures and images.
ModelPlaces append_resources(Model& target, const Model& source);

/// Appends an instance: nodes, with the roots of `source`'s default scene below the node `parent`, and cameras, lights,
/// skins and animations of its own. `places` is what append_resources gave for `source`; returns it completed. Nodes
/// without a name get the one that a spawned model has ("node 3"), so that paths of names stay what they are. What the
/// animations' pointers mean is followed.
ModelPlaces append_instance(Model& target, const Model& source, ModelPlaces places, std::int32_t parent);

} // namespace hachure::assets
