#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/animation/playback.h>

#include <vector>

namespace hachure {

/// Where one timeline is, from frame to frame. `Timeline::time` counts in the direction of play, as Animation's does.
class TimelineClock {
public:
    /// Moves on by `delta` seconds. `time` is what Timeline::time becomes, `place` the moment of the document, and
    /// `passed` the actions on the way, in order. True when the place is another than before, or was never shown.
    ///
    /// A timeline that begins at its start does also what stands there; one that is set to another time does only what
    /// comes after it.
    bool advance(const Timeline& timeline, double delta);

    double time = 0.0;  ///< out
    double place = 0.0; ///< out: seconds of the document
    std::vector<animation::PassedEvent> passed;

private:
    void start_or_jump(const Timeline& timeline);

    animation::Playback playback_;
    double done_until_ = animation::not_started; ///< actions up to this playing time are done
    bool started_ = false;
};

} // namespace hachure
