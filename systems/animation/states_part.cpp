#include <hachure/systems/animation/animation_parts.h>
#include <hachure/systems/animation/part_source.h>
#include <hachure/systems/animation/states_json.h>

namespace hachure {
namespace {

using nlohmann::json;

constexpr const char* states_name = "animation_states";

void add_states(World& world, Entity entity, const ScenePartSource& source) {
    const assets::JsonValue value(source.text, source.pointer, source.value);
    const animation::ClipSet* clips = clips_of(world, entity);
    if (!clips) value.fail("there is no model with clips here");
    AnimationStates states = read_states(value, *clips);
    remember_source(world, entity, states_name, source.value, write_states(states, *clips));
    world.add(entity, std::move(states));
}

std::optional<json> states_json(const World& world, Entity entity) {
    const AnimationStates* states = world.find<AnimationStates>(entity);
    const animation::ClipSet* clips = clips_of(world, entity);
    // A machine that does nothing can't be read again either.
    if (!states || !clips || !animation::check_state_machine(states->machine).empty()) return std::nullopt;
    return as_it_was(world, entity, states_name, write_states(*states, *clips));
}

} // namespace

json states_schema() {
    return json::parse(R"json({
  "type": "object", "required": ["states"], "additionalProperties": false,
  "properties": {
    "parameters": {"type": "object", "additionalProperties": {"anyOf": [
      {"type": "number"}, {"type": "boolean"}, {"const": "trigger"}]}},
    "values": {"type": "object", "additionalProperties": {"type": ["number", "boolean"]}},
    "states": {"type": "array", "minItems": 1, "items": {
      "type": "object", "required": ["name"], "additionalProperties": false,
      "properties": {
        "name": {"type": "string"}, "clip": {"type": "string"},
        "repeat": {"enum": ["once", "loop", "ping_pong"], "default": "loop"},
        "speed": {"type": "number", "minimum": -1000, "maximum": 1000, "default": 1},
        "offset": {"type": "number", "minimum": -1e6, "maximum": 1e6, "default": 0}}}},
    "transitions": {"type": "array", "items": {
      "type": "object", "required": ["to"], "additionalProperties": false,
      "properties": {
        "from": {"type": "string", "description": "any state when absent"}, "to": {"type": "string"},
        "when": {"type": "array", "items": {
          "type": "object", "required": ["parameter"], "minProperties": 2, "maxProperties": 2,
          "additionalProperties": false,
          "properties": {
            "parameter": {"type": "string"}, "less": {"type": "number"}, "less_equal": {"type": "number"},
            "greater": {"type": "number"}, "greater_equal": {"type": "number"}, "equal": {"type": "number"},
            "not_equal": {"type": "number"}, "set": {"type": "boolean"}}}},
        "fade": {"type": "number", "minimum": 0, "maximum": 1000, "default": 0.2},
        "after": {"type": "number", "minimum": 0, "description": "how often the clip is played first"},
        "to_itself": {"type": "boolean", "default": false}}}}
  }
})json");
}

ScenePart animation_states_part() {
    return {states_name, "a state machine that chooses what a model plays", states_schema(), add_states, states_json};
}

} // namespace hachure
