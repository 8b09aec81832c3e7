#include <hachure/systems/timeline/timeline_clock.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

animation::Playback playback_of(const Timeline& timeline) {
    constexpr animation::LoopMode modes[] = {animation::LoopMode::once, animation::LoopMode::loop,
                                             animation::LoopMode::ping_pong};
    return {timeline.document->duration, timeline.speed < 0.0f ? -1.0 : 1.0,
            modes[static_cast<std::size_t>(timeline.repeat)], 0.0};
}

} // namespace

/// Takes in what others changed.
void TimelineClock::start_or_jump(const Timeline& timeline) {
    const animation::Playback wanted = playback_of(timeline);
    if (!started_ || timeline.time != time) {
        time = timeline.time;
        done_until_ = time == 0.0 ? animation::not_started : time;
    } else if (wanted.speed != playback_.speed && done_until_ >= 0.0) {
        // It turns round where it is.
        time += animation::with_speed(playback_, time, wanted.speed).offset;
        done_until_ = time;
    }
    playback_ = wanted;
}

bool TimelineClock::advance(const Timeline& timeline, double delta) {
    const bool first = !started_;
    const double old_place = place;
    start_or_jump(timeline);
    started_ = true;
    passed.clear();
    if (timeline.playing) {
        double end = time + delta * std::abs(double{timeline.speed});
        if (timeline.repeat == Repeat::once) end = std::min(end, std::max(time, playback_.duration));
        // What a component may hold; a timeline stops there, after thirty years.
        end = std::min(end, 1e9);
        animation::PassedEventsJob job{timeline.document->moments, playback_, done_until_, end, &passed};
        job.validate();
        job.run();
        time = done_until_ = end;
    }
    place = animation::clip_time(playback_, time);
    return first || place != old_place;
}

} // namespace hachure
