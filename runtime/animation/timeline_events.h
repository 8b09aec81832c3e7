#pragma once

#include <hachure/runtime/animation/playback.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hachure::animation {

/// Something that happens at a moment of a clip: a footstep.
struct TimelineEvent {
    double time = 0.0; ///< seconds of the clip
    std::string name;
};

/// Sorts events by time, those of one time in their order. Times outside [0, duration] move to its nearer end; events
/// whose time is not a number are left out. Both are said in `warnings`, one line each that names the event.
[[nodiscard]] std::vector<TimelineEvent> sort_events(std::vector<TimelineEvent> events, double duration,
                                                     std::vector<std::string>& warnings);

/// An event that was passed.
struct PassedEvent {
    std::uint32_t event = 0; ///< into the events
    double time = 0.0;       ///< the playing time at which it happens, seconds; not after the step's end

    friend bool operator==(const PassedEvent&, const PassedEvent&) = default;
};

/// Which events a step of playing passes, in the order in which they happen: those after playing time `from`, up to and
/// including `to`. However a time is divided into steps, each event happens exactly once. When played backwards, events
/// of one time come in reverse order. A step over more than PassedIntervals::most_cycles cycles gives the events of the
/// last ones.
struct PassedEventsJob {
    std::span<const TimelineEvent> events; ///< as sort_events gives them
    Playback playback;
    double from = not_started; ///< playing time, seconds; negative before the first step
    double to = 0.0;
    std::vector<PassedEvent>* passed = nullptr; ///< out: replaced; its capacity is kept from run to run

    /// Asserts that the events are sorted and in range.
    void validate() const;
    void run();
};

} // namespace hachure::animation
