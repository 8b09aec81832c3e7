#pragma once

#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/assets/json_value.h>
#include <hachure/runtime/scene/scene_parts.h>

namespace hachure {

/// Parts of scene files for what an entity with a model's clips (Rig) plays, beside the component "animation"; clips
/// and states go by their names. docs/timelines.md shows them.
[[nodiscard]] ScenePart animation_states_part(); ///< "animation_states": AnimationStates
[[nodiscard]] ScenePart animation_layers_part(); ///< "animation_layers": AnimationLayers
[[nodiscard]] ScenePart animation_events_part(); ///< "animation_events": AnimationEvents

/// The clips of the model whose root `entity` is; null when it is none.
[[nodiscard]] const animation::ClipSet* clips_of(const World& world, Entity entity);

/// Says, with its place, that a name is that of none of the clips; not where there is no model.
void warn_of_unknown_clip(const World& world, Entity entity, const assets::JsonValue& name,
                          std::vector<std::string>& warnings);

} // namespace hachure
