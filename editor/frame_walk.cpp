#include <hachure/editor/frame_walk.h>

namespace hachure {

void walk_frames(const FramePlan& plan, std::span<const std::int64_t> wanted, FrameHistory history,
                 const std::function<void(const FrameStep&)>& take) {
    std::int64_t next = 0; // the first frame that was not passed
    for (const std::int64_t number : wanted) {
        const double seconds = plan.seconds(number);
        if (history == FrameHistory::whole) {
            // For a moment between two frames, those before it; else those before the frame.
            for (; plan.time ? plan.rate.time_of(next) < seconds : next < number; ++next)
                take({next, plan.rate.time_of(next), false});
        } else if (history == FrameHistory::motion && number > next) {
            take({number - 1, plan.seconds(number - 1), false});
        }
        take({number, seconds, true});
        next = number + 1;
    }
}

} // namespace hachure
