#pragma once

#include <hachure/components/animation_states.h>
#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/assets/json_value.h>

#include <nlohmann/json_fwd.hpp>

namespace hachure {

/// Reads a state machine with the values of its parameters, for a model with these clips. Throws Error with line and
/// column for everything that it does not understand, names of clips, states and parameters included.
[[nodiscard]] AnimationStates read_states(const assets::JsonValue& value, const animation::ClipSet& clips);

/// What read_states makes the same from; where the machine is is not part of it.
[[nodiscard]] nlohmann::json write_states(const AnimationStates& states, const animation::ClipSet& clips);

/// JSON schema (2020-12) of it.
[[nodiscard]] nlohmann::json states_schema();

} // namespace hachure
