#include <hachure/runtime/animation/state_machine.h>

#include <cmath>
#include <set>

namespace hachure::animation {
namespace {

class Check {
public:
    explicit Check(const StateMachine& machine) : machine_(machine) {}

    std::vector<std::string> run() {
        if (machine_.states.empty()) faults_.emplace_back("it has no states");
        check_names("state", machine_.states);
        check_names("parameter", machine_.parameters);
        for (const State& state : machine_.states) check_playback(state);
        for (const Parameter& parameter : machine_.parameters)
            require(std::isfinite(parameter.initial), "parameter '" + parameter.name + "' starts with no number");
        for (std::size_t i = 0; i < machine_.transitions.size(); ++i) check_transition(i);
        return std::move(faults_);
    }

private:
    void require(bool condition, const std::string& fault) {
        if (!condition) faults_.push_back(fault);
    }

    template <typename Named> void check_names(const std::string& kind, const std::vector<Named>& all) {
        std::set<std::string_view> names;
        for (const Named& one : all)
            require(names.insert(one.name).second, "two " + kind + "s have the name '" + one.name + "'");
    }

    void check_playback(const State& state) {
        const Playback& p = state.playback;
        require(std::isfinite(p.duration) && p.duration >= 0.0 && std::isfinite(p.speed) && std::isfinite(p.offset),
                "state '" + state.name + "' has a duration, speed or offset out of range");
    }

    void check_transition(std::size_t index) {
        const Transition& transition = machine_.transitions[index];
        const std::string name = "transition " + std::to_string(index);
        const auto states = static_cast<std::int64_t>(machine_.states.size());
        require(transition.from >= any_state && transition.from < states, name + " starts at no state");
        require(transition.to < machine_.states.size(), name + " leads to no state");
        require(std::isfinite(transition.duration) && transition.duration >= 0.0,
                name + " has a duration out of range");
        require(!transition.exit_time || (std::isfinite(*transition.exit_time) && *transition.exit_time >= 0.0),
                name + " has an exit time out of range");
        for (const Condition& condition : transition.conditions) {
            require(condition.parameter < machine_.parameters.size(), name + " asks for no parameter");
            require(std::isfinite(condition.value), name + " compares with no number");
        }
    }

    const StateMachine& machine_;
    std::vector<std::string> faults_;
};

} // namespace

std::vector<std::string> check_state_machine(const StateMachine& machine) { return Check(machine).run(); }

} // namespace hachure::animation
