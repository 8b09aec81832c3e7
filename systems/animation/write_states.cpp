#include <hachure/systems/animation/part_source.h>
#include <hachure/systems/animation/states_json.h>

namespace hachure {
namespace {

using animation::ParameterKind;
using nlohmann::json;

json write_parameter(const animation::Parameter& parameter) {
    switch (parameter.kind) {
    case ParameterKind::flag:
        return parameter.initial != 0.0f;
    case ParameterKind::trigger:
        return "trigger";
    case ParameterKind::number:
        break;
    }
    return shortest_number(parameter.initial);
}

json write_state(const animation::State& state, const animation::ClipSet& clips) {
    json result{{"name", state.name}};
    const animation::Playback usual, &playback = state.playback;
    if (state.clip >= 0 && static_cast<std::size_t>(state.clip) < clips.clips.size())
        result["clip"] = clips.clips[static_cast<std::size_t>(state.clip)].name;
    constexpr const char* repeats[] = {"once", "loop", "ping_pong"};
    if (playback.mode != usual.mode) result["repeat"] = repeats[static_cast<std::size_t>(playback.mode)];
    if (playback.speed != usual.speed) result["speed"] = playback.speed;
    if (playback.offset != usual.offset) result["offset"] = playback.offset;
    return result;
}

json write_condition(const animation::StateMachine& machine, const animation::Condition& condition) {
    using animation::Comparison;
    json result{{"parameter", machine.parameters[condition.parameter].name}};
    constexpr const char* words[] = {"less", "less_equal", "greater", "greater_equal", "equal", "not_equal"};
    if (condition.comparison == Comparison::set || condition.comparison == Comparison::not_set)
        result["set"] = condition.comparison == Comparison::set;
    else
        result[words[static_cast<std::size_t>(condition.comparison)]] = shortest_number(condition.value);
    return result;
}

json write_transition(const animation::StateMachine& machine, const animation::Transition& transition) {
    json result{{"to", machine.states[transition.to].name}};
    if (transition.from != animation::any_state)
        result["from"] = machine.states[static_cast<std::size_t>(transition.from)].name;
    for (const animation::Condition& condition : transition.conditions)
        result["when"].push_back(write_condition(machine, condition));
    if (transition.duration != animation::Transition{}.duration) result["fade"] = transition.duration;
    if (transition.exit_time) result["after"] = *transition.exit_time;
    if (transition.to_itself) result["to_itself"] = true;
    return result;
}

} // namespace

json write_states(const AnimationStates& states, const animation::ClipSet& clips) {
    const animation::StateMachine& machine = states.machine;
    json result{{"states", json::array()}};
    for (const animation::State& state : machine.states) result["states"].push_back(write_state(state, clips));
    for (const animation::Transition& transition : machine.transitions)
        result["transitions"].push_back(write_transition(machine, transition));
    for (std::size_t i = 0; i < machine.parameters.size(); ++i) {
        const animation::Parameter& parameter = machine.parameters[i];
        result["parameters"][parameter.name] = write_parameter(parameter);
        const float initial = parameter.kind == ParameterKind::trigger ? 0.0f : parameter.initial;
        if (i < states.parameters.size() && states.parameters[i] != initial)
            result["values"][parameter.name] = shortest_number(states.parameters[i]);
    }
    return result;
}

} // namespace hachure
