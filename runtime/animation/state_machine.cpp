#include <hachure/runtime/animation/state_machine.h>
#include <hachure/runtime/assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::animation {
namespace {

bool holds(const Condition& condition, float parameter) {
    if (std::isnan(parameter)) return false;
    switch (condition.comparison) {
    case Comparison::less:
        return parameter < condition.value;
    case Comparison::less_equal:
        return parameter <= condition.value;
    case Comparison::greater:
        return parameter > condition.value;
    case Comparison::greater_equal:
        return parameter >= condition.value;
    case Comparison::equal:
        return parameter == condition.value;
    case Comparison::not_equal:
        return parameter != condition.value;
    case Comparison::set:
        return parameter != 0.0f;
    case Comparison::not_set:
        break;
    }
    return parameter == 0.0f;
}

/// The playing time at which a clip has been played `times` over.
double exit_moment(const Playback& playback, double times) {
    const double distance = times * playback.duration - playback.offset;
    if (playback.duration == 0.0 || distance <= 0.0) return 0.0;
    return playback.speed == 0.0 ? std::numeric_limits<double>::infinity() : distance / std::abs(playback.speed);
}

/// One step of a machine.
class Step {
public:
    Step(const StateMachine& machine, std::span<float> parameters, StateMachineState& state)
        : machine_(machine), parameters_(parameters), state_(state) {}

    void run(double delta) {
        if (state_.count == 0)
            enter(0, 0.0);
        else
            for (std::size_t i = 0; i < state_.count; ++i) state_.active[i].previous_time = state_.active[i].time;
        std::size_t at_one_moment = 0;
        for (int taken = 0; taken < most_transitions; ++taken) {
            const Candidate next = find_next(delta);
            if (next.transition == nullptr) break;
            at_one_moment = next.wait > 0.0 ? 1 : at_one_moment + 1;
            if (at_one_moment > machine_.states.size()) break;
            advance(next.wait);
            delta -= next.wait;
            take(*next.transition);
        }
        advance(delta);
        weigh();
    }

private:
    struct Candidate {
        const Transition* transition = nullptr;
        double wait = 0.0; ///< seconds until it is possible
    };

    [[nodiscard]] Candidate find_next(double within) const {
        Candidate best;
        const ActiveState& now = state_.active[state_.count - 1];
        const Playback& playback = machine_.states[now.state].playback;
        for (const Transition& transition : machine_.transitions) {
            if (!leaves(transition, now.state) || !conditions_hold(transition)) continue;
            const double exit = transition.exit_time ? exit_moment(playback, *transition.exit_time) : 0.0;
            const double wait = std::max(exit - now.time, 0.0);
            if (wait <= within && (best.transition == nullptr || wait < best.wait)) best = {&transition, wait};
        }
        return best;
    }

    static bool leaves(const Transition& transition, std::uint32_t state) {
        if (transition.from == any_state) return transition.to != state || transition.to_itself;
        return transition.from == static_cast<std::int32_t>(state);
    }

    [[nodiscard]] bool conditions_hold(const Transition& transition) const {
        return std::ranges::all_of(transition.conditions,
                                   [this](const Condition& c) { return holds(c, parameters_[c.parameter]); });
    }

    void advance(double seconds) {
        for (std::size_t i = 0; i < state_.count; ++i) state_.active[i].time += seconds;
    }

    void take(const Transition& transition) {
        for (const Condition& condition : transition.conditions)
            if (machine_.parameters[condition.parameter].kind == ParameterKind::trigger)
                parameters_[condition.parameter] = 0.0f;
        enter(transition.to, transition.duration);
    }

    void enter(std::uint32_t state, double fade_length) {
        forget_faded();
        if (state_.count == StateMachineState::most_active) forget(1);
        state_.active[state_.count++] = {state, not_started, 0.0, fade_length, 1.0f};
    }

    void forget(std::size_t oldest) {
        std::shift_left(state_.active.begin(), state_.active.begin() + static_cast<std::ptrdiff_t>(state_.count),
                        static_cast<std::ptrdiff_t>(oldest));
        state_.count -= oldest;
        // Equal machines are equal in memory that they don't use, too.
        std::fill(state_.active.begin() + static_cast<std::ptrdiff_t>(state_.count), state_.active.end(),
                  ActiveState{});
    }

    /// How far a state has faded in over what is older.
    static double presence(const ActiveState& active) {
        return active.time >= active.fade_length ? 1.0 : active.time / active.fade_length;
    }

    /// Behind a state that is fully there nothing older is seen.
    void forget_faded() {
        for (std::size_t i = state_.count; i-- > 1;)
            if (presence(state_.active[i]) >= 1.0) return forget(i);
    }

    void weigh() {
        forget_faded();
        double left = 1.0;
        for (std::size_t i = state_.count; i-- > 0;) {
            const double weight = i == 0 ? left : left * presence(state_.active[i]);
            state_.active[i].weight = static_cast<float>(weight);
            left -= weight;
        }
    }

    const StateMachine& machine_;
    std::span<float> parameters_;
    StateMachineState& state_;
};

template <typename Named>
std::optional<std::uint32_t> find_named(const std::vector<Named>& all, std::string_view name) {
    const auto at = std::ranges::find(all, name, &Named::name);
    if (at == all.end()) return std::nullopt;
    return static_cast<std::uint32_t>(at - all.begin());
}

} // namespace

std::optional<std::uint32_t> find_state(const StateMachine& machine, std::string_view name) {
    return find_named(machine.states, name);
}

std::optional<std::uint32_t> find_parameter(const StateMachine& machine, std::string_view name) {
    return find_named(machine.parameters, name);
}

std::vector<float> initial_parameters(const StateMachine& machine) {
    std::vector<float> values;
    for (const Parameter& parameter : machine.parameters) values.push_back(parameter.initial);
    return values;
}

void step_state_machine(const StateMachine& machine, std::span<float> parameters, double delta,
                        StateMachineState& state) {
    HACHURE_ASSERT(!machine.states.empty(), "a machine has states");
    HACHURE_ASSERT(parameters.size() == machine.parameters.size(), "one value per parameter");
    HACHURE_ASSERT(std::isfinite(delta) && delta >= 0.0, "time is finite and does not run backwards");
    Step(machine, parameters, state).run(delta);
}

} // namespace hachure::animation
