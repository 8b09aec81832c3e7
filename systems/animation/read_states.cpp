#include <hachure/systems/animation/states_json.h>

#include <limits>
#include <utility>

namespace hachure {
namespace {

using animation::Comparison;
using animation::StateMachine;
using assets::in_quotes;
using assets::JsonValue;

constexpr std::size_t most = 10'000; // states, transitions, conditions
constexpr double largest = std::numeric_limits<float>::max();

/// A number, a flag, or "trigger".
animation::Parameter read_parameter(const std::string& name, const JsonValue& value) {
    using animation::ParameterKind;
    if (value.json().is_boolean()) return {name, ParameterKind::flag, value.flag() ? 1.0f : 0.0f};
    if (value.json().is_number())
        return {name, ParameterKind::number, static_cast<float>(value.number(-largest, largest))};
    (void)value.option({"trigger"});
    return {name, ParameterKind::trigger, 0.0f};
}

animation::State read_state(const JsonValue& value, const animation::ClipSet& clips) {
    value.require_keys({"name", "clip", "repeat", "speed", "offset"});
    animation::State state;
    state.name = value.at("name").string();
    if (const auto name = value.find("clip")) {
        const auto clip = animation::find_clip(clips, name->string());
        if (!clip) name->fail("the model has no clip " + in_quotes(name->string()));
        state.clip = static_cast<std::int32_t>(*clip);
        state.playback.duration = clips.clips[*clip].duration;
    }
    if (const auto repeat = value.find("repeat"))
        state.playback.mode = static_cast<animation::LoopMode>(repeat->option({"once", "loop", "ping_pong"}));
    if (const auto speed = value.find("speed")) state.playback.speed = speed->number(-1000, 1000);
    if (const auto offset = value.find("offset")) state.playback.offset = offset->number(-1e6, 1e6);
    return state;
}

std::uint32_t state_called(const StateMachine& machine, const JsonValue& name) {
    const auto state = animation::find_state(machine, name.string());
    if (!state) name.fail("there is no state " + in_quotes(name.string()));
    return *state;
}

/// `{"parameter": name, comparison: value}`
animation::Condition read_condition(const StateMachine& machine, const JsonValue& value) {
    value.require_keys({"parameter", "less", "less_equal", "greater", "greater_equal", "equal", "not_equal", "set"});
    const JsonValue name = value.at("parameter");
    const auto parameter = animation::find_parameter(machine, name.string());
    if (!parameter) name.fail("there is no parameter " + in_quotes(name.string()));
    if (value.json().size() != 2) value.fail("a condition compares its parameter once");
    if (const auto set = value.find("set"))
        return {*parameter, set->flag() ? Comparison::set : Comparison::not_set, 0.0f};
    constexpr std::pair<const char*, Comparison> comparisons[] = {
        {"less", Comparison::less},       {"less_equal", Comparison::less_equal},
        {"greater", Comparison::greater}, {"greater_equal", Comparison::greater_equal},
        {"equal", Comparison::equal},     {"not_equal", Comparison::not_equal}};
    for (const auto& [word, comparison] : comparisons)
        if (const auto number = value.find(word))
            return {*parameter, comparison, static_cast<float>(number->number(-largest, largest))};
    value.fail("a condition compares its parameter once");
}

animation::Transition read_transition(const StateMachine& machine, const JsonValue& value) {
    value.require_keys({"from", "to", "when", "fade", "after", "to_itself"});
    animation::Transition transition;
    if (const auto from = value.find("from")) transition.from = static_cast<std::int32_t>(state_called(machine, *from));
    transition.to = state_called(machine, value.at("to"));
    const auto when = value.find("when");
    const std::size_t count = when ? when->array_size(most) : 0;
    for (std::size_t i = 0; i < count; ++i) transition.conditions.push_back(read_condition(machine, when->at(i)));
    if (const auto fade = value.find("fade")) transition.duration = fade->number(0, 1000);
    if (const auto after = value.find("after")) transition.exit_time = after->number(0, 1e6);
    if (const auto itself = value.find("to_itself")) transition.to_itself = itself->flag();
    return transition;
}

/// Values that are not those at the start.
void read_values(AnimationStates& states, const JsonValue& value) {
    if (!value.json().is_object()) value.fail("values of parameters are an object");
    for (const auto& [name, number] : value.json().items()) {
        const JsonValue given = value.at(name);
        const auto parameter = animation::find_parameter(states.machine, name);
        if (!parameter) given.fail("there is no parameter " + in_quotes(name));
        states.parameters[*parameter] =
            number.is_boolean() ? (given.flag() ? 1.0f : 0.0f) : static_cast<float>(given.number(-largest, largest));
    }
}

} // namespace

AnimationStates read_states(const JsonValue& value, const animation::ClipSet& clips) {
    value.require_keys({"parameters", "values", "states", "transitions"});
    StateMachine machine;
    if (const auto parameters = value.find("parameters")) {
        if (!parameters->json().is_object()) parameters->fail("parameters are an object");
        for (const auto& [name, initial] : parameters->json().items())
            machine.parameters.push_back(read_parameter(name, parameters->at(name)));
    }
    const JsonValue states = value.at("states");
    const std::size_t count = states.array_size(most);
    for (std::size_t i = 0; i < count; ++i) machine.states.push_back(read_state(states.at(i), clips));
    const auto transitions = value.find("transitions");
    const std::size_t ways = transitions ? transitions->array_size(most) : 0;
    for (std::size_t i = 0; i < ways; ++i) machine.transitions.push_back(read_transition(machine, transitions->at(i)));
    if (const std::vector<std::string> faults = animation::check_state_machine(machine); !faults.empty())
        value.fail(faults.front());
    AnimationStates result = AnimationStates::make(std::move(machine));
    if (const auto values = value.find("values")) read_values(result, *values);
    return result;
}

} // namespace hachure
