#pragma once

#include <hachure/systems/scene/build_scene.h>
#include <hachure/systems/styles/style.h>

namespace hachure {

/// Gives the entities of a built scene what is said of them. Later things refine earlier ones: the style (null for
/// none), looks from the outer to the inner, what stands beside the entity, overrides from the inner to the outer; then
/// fields that hold entities, when all names are known; at last the scene parts (runtime/scene/scene_parts.h).
void dress_scene(World& world, const SceneTypes& types, const BuiltScene& scene, const Style* style,
                 SceneFaults& faults);

} // namespace hachure
