#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/entity_map.h>

#include <cstdint>
#include <vector>

namespace hachure {

/// Binds a surface to joints, which deform it; its mesh has the weights.
struct Skin {
    std::uint32_t binding = 0;  ///< index into the world's MeshStore: the skin's inverse bind matrices
    std::vector<Entity> joints; ///< by joint of the skin; null where the scene lacks the node, which then stands still
};

inline void remap_entities(Skin& skin, const EntityMap& copies) {
    for (Entity& joint : skin.joints) joint = copies(joint);
}

} // namespace hachure
