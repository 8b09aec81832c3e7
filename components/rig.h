#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/entity_map.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hachure {

/// A field that a clip moves besides the nodes' transforms and weights.
struct RigPointer {
    std::uint32_t clip = 0;    ///< of the rig
    std::uint32_t channel = 0; ///< into the clip's pointers
    Entity entity;
    std::string component, field; ///< reflected names: a number, a vector or a boolean
};

/// On the root of a model: what clips move. Copies of the model (`World::instantiate`) have a rig of their own.
struct Rig {
    std::uint32_t clips = 0;          ///< index into the world's ClipStore
    std::vector<Entity> nodes;        ///< by node of the file; null where the scene has none of it
    std::vector<Entity> morphs;       ///< by node of the file: its entity with MorphWeights, or null
    std::vector<RigPointer> pointers; ///< sorted by clip
};

inline void remap_entities(Rig& rig, const EntityMap& copies) {
    for (Entity& node : rig.nodes) node = copies(node);
    for (Entity& node : rig.morphs) node = copies(node);
    for (RigPointer& pointer : rig.pointers) pointer.entity = copies(pointer.entity);
}

} // namespace hachure
