#pragma once

#include <cstdint>

namespace hachure {

/// Resource: the time of a frame or, in a system of fixed step, of a step. `Schedule::run` sets it.
struct Time {
    double delta = 0;        ///< seconds since the frame (step) before this one; in fixed systems the step
    double elapsed = 0;      ///< seconds, the sum of `delta` of all frames (steps), this one included
    std::uint64_t frame = 0; ///< how many frames came before this one

    /// How far the frame's time has got from the last fixed step to the next, in [0, 1): the weight of the newest state
    /// when two are blended. 0 in fixed systems.
    double step_fraction = 0;
};

} // namespace hachure
