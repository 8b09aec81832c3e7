#pragma once

#include <hachure/runtime/animation/state_machine.h>

#include <utility>
#include <vector>

namespace hachure {

/// Chooses what a model plays by a state machine, in place of Animation's `clip`. The states' clips are indices into
/// the rig's clips.
struct AnimationStates {
    animation::StateMachine machine;    ///< check_state_machine finds nothing wrong with it; else it does nothing
    std::vector<float> parameters;      ///< one per parameter of the machine; set them to steer it
    animation::StateMachineState state; ///< where it is

    /// A machine with its parameters at their initial values.
    static AnimationStates make(animation::StateMachine machine) {
        AnimationStates states;
        states.parameters = animation::initial_parameters(machine);
        states.machine = std::move(machine);
        return states;
    }
};

} // namespace hachure
