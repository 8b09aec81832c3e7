#pragma once

#include <hachure/runtime/animation/playback.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::animation {

enum class ParameterKind : std::uint8_t {
    number,
    flag,    ///< 0 or 1
    trigger, ///< a flag that a transition takes back when it uses it
};

/// Something from outside that transitions ask for. Its value is one float of the span that the step is given.
struct Parameter {
    std::string name;
    ParameterKind kind = ParameterKind::number;
    float initial = 0.0f;
};

enum class Comparison : std::uint8_t { less, less_equal, greater, greater_equal, equal, not_equal, set, not_set };

/// `parameter comparison value`; `set` and `not_set` ask whether it is 0 and need no value. A parameter that is not a
/// number fulfils no condition.
struct Condition {
    std::uint32_t parameter = 0; ///< into StateMachine::parameters
    Comparison comparison = Comparison::set;
    float value = 0.0f;
};

/// A clip and how it is played.
struct State {
    std::string name;
    std::int32_t clip = -1; ///< into a ClipSet; -1 for the rest pose
    Playback playback;      ///< with the clip's duration
};

inline constexpr std::int32_t any_state = -1;

/// A way from one state to another, taken when all its conditions hold.
struct Transition {
    std::int32_t from = any_state; ///< into StateMachine::states, or any_state
    std::uint32_t to = 0;
    std::vector<Condition> conditions{}; ///< none: taken as soon as the exit time allows it
    double duration = 0.2;               ///< of the cross-fade, seconds, at least 0
    /// Not before the state's clip has been played this often since the state was entered (1: to its end).
    std::optional<double> exit_time{};
    bool to_itself = false; ///< for any_state: whether the target state, too, is left for itself
};

/// States and transitions as plain data. When several transitions are possible at one moment, the first is taken.
struct StateMachine {
    std::vector<Parameter> parameters;
    std::vector<State> states; ///< at least one; the first is where it starts
    std::vector<Transition> transitions;
};

/// What is wrong with a machine, one line each that names the state, transition or parameter; empty when it can be
/// stepped.
[[nodiscard]] std::vector<std::string> check_state_machine(const StateMachine& machine);

[[nodiscard]] std::optional<std::uint32_t> find_state(const StateMachine& machine, std::string_view name);
[[nodiscard]] std::optional<std::uint32_t> find_parameter(const StateMachine& machine, std::string_view name);

/// The values with which a machine starts, one float per parameter.
[[nodiscard]] std::vector<float> initial_parameters(const StateMachine& machine);

/// A state that plays at the moment. `previous_time` and `time` are playing times before and after the step, for
/// clip_time, PassedEventsJob and root motion; `previous_time` is not_started in the step that enters the state.
struct ActiveState {
    std::uint32_t state = 0;
    double previous_time = not_started;
    double time = 0.0;        ///< seconds since it was entered
    double fade_length = 0.0; ///< seconds that its cross-fade takes, 0 for none
    float weight = 1.0f;      ///< of its pose; the weights of a machine's active states sum to 1

    friend bool operator==(const ActiveState&, const ActiveState&) = default;
};

/// Where a machine is. Plain data: copied to save it.
struct StateMachineState {
    /// A cross-fade that interrupts another keeps what was faded from; beyond this many states the oldest is left out.
    static constexpr std::size_t most_active = 4;
    std::array<ActiveState, most_active> active{}; ///< oldest first; the last one is the state that it is in
    std::size_t count = 0;                         ///< 0 before the first step

    [[nodiscard]] std::span<const ActiveState> states() const { return {active.data(), count}; }
    /// The state that it is in, or fades to.
    [[nodiscard]] std::uint32_t current() const { return count == 0 ? 0 : active[count - 1].state; }

    friend bool operator==(const StateMachineState&, const StateMachineState&) = default;
};

/// Moves a machine on by `delta` seconds (at least 0), while the parameters stay as they are. Transitions are taken at
/// the moment within the step at which they become possible, so that exit times don't depend on the frame rate; the
/// rest of the step belongs to the new state. A trigger that a taken transition asks for is set to 0 in `parameters`.
/// Within one step at most `most_transitions` are taken, and without time passing no more than there are states: rings
/// of instantaneous transitions end. The machine passed check_state_machine; `parameters` has one float each. Allocates
/// nothing.
void step_state_machine(const StateMachine& machine, std::span<float> parameters, double delta,
                        StateMachineState& state);
inline constexpr int most_transitions = 64;

} // namespace hachure::animation
