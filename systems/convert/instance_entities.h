#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/ecs/world.h>

#include <vector>

namespace hachure {

/// The entities of a spawned model, by node of the file; null where a node has none.
struct InstanceEntities {
    std::vector<Entity> nodes;
    std::vector<Entity> surfaces; ///< what draws the node's mesh: its own entity, or one below the root (skinned)
};

/// Finds them again by their places below `root`, where spawn_model put them in the order of the file; what was added
/// below them later comes after them.
[[nodiscard]] InstanceEntities instance_entities(const World& world, const assets::Model& model, Entity root);

} // namespace hachure
