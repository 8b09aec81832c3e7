#pragma once

#include <cstdint>

namespace hachure::detail {

/// Cuts the time of frames, which is uneven, into steps of equal length. After any number of frames, the steps taken
/// and dropped are as many as fit into the time elapsed: they are counted, not accumulated, so nothing drifts.
class FixedStep {
public:
    FixedStep() = default;

    /// Steps of `seconds` (greater than 0), at most `max_steps` (1 or more) for one frame.
    FixedStep(double seconds, int max_steps);

    /// A frame of `delta` seconds (0 or more, finite). Returns how many steps it asks for, `max_steps` at most; what
    /// goes beyond that is dropped.
    int advance(double delta);

    double seconds() const { return seconds_; }

    /// The steps that `advance` returned so far.
    std::uint64_t taken() const { return taken_; }

    /// The steps that were dropped so far.
    std::uint64_t dropped() const { return dropped_; }

    /// The time of all frames, seconds.
    double elapsed() const { return elapsed_; }

    /// How far time has got from the last step to the next, in [0, 1).
    double fraction() const;

private:
    double seconds_ = 1.0 / 60.0;
    int max_steps_ = 8;
    std::uint64_t taken_ = 0;
    std::uint64_t dropped_ = 0;
    double elapsed_ = 0;   ///< the sum of all frames, rounded
    double remainder_ = 0; ///< what the rounding took off
};

} // namespace hachure::detail
