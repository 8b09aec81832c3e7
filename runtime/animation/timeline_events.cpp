#include <hachure/runtime/animation/timeline_events.h>
#include <hachure/runtime/assert.h>

#include <algorithm>
#include <cmath>

namespace hachure::animation {

std::vector<TimelineEvent> sort_events(std::vector<TimelineEvent> events, double duration,
                                       std::vector<std::string>& warnings) {
    HACHURE_ASSERT(duration >= 0.0, "a duration is not negative");
    std::erase_if(events, [&](const TimelineEvent& event) {
        if (std::isnan(event.time)) warnings.push_back("event '" + event.name + "' has no time and is left out");
        return std::isnan(event.time);
    });
    for (TimelineEvent& event : events) {
        const double inside = std::clamp(event.time, 0.0, duration);
        if (event.time != inside)
            warnings.push_back("event '" + event.name + "' lies outside of its clip and is moved");
        event.time = inside;
    }
    std::ranges::stable_sort(events, {}, &TimelineEvent::time);
    return events;
}

namespace {

/// The playing time at which a moment of the clip is passed in a stretch.
double playing_time(const PassedEventsJob& job, const ClipInterval& passed, double time) {
    const double speed = std::abs(job.playback.speed);
    const double local = passed.forward ? time : job.playback.duration - time;
    const double earliest = std::max(job.from, 0.0);
    if (speed == 0.0) return earliest;
    const double when = (passed.cycle * job.playback.duration + local - job.playback.offset) / speed;
    return std::clamp(when, earliest, job.to);
}

} // namespace

void PassedEventsJob::validate() const {
    HACHURE_ASSERT(passed != nullptr, "there is room for the result");
    HACHURE_ASSERT(std::ranges::is_sorted(events, {}, &TimelineEvent::time), "events are sorted");
    HACHURE_ASSERT(events.empty() || (events.front().time >= 0.0 && events.back().time <= playback.duration),
                   "events lie in their clip");
}

void PassedEventsJob::run() {
    passed->clear();
    if (events.empty()) return;
    for (PassedIntervals stretches(playback, from, to); stretches.next();) {
        const ClipInterval& stretch = stretches.interval();
        const auto low = std::ranges::lower_bound(events, std::min(stretch.from, stretch.to), {}, &TimelineEvent::time);
        const auto high =
            std::ranges::upper_bound(events, std::max(stretch.from, stretch.to), {}, &TimelineEvent::time);
        const std::size_t begin = passed->size();
        for (auto event = low; event != high; ++event)
            if (stretch.contains(event->time))
                passed->push_back(
                    {static_cast<std::uint32_t>(event - events.begin()), playing_time(*this, stretch, event->time)});
        if (!stretch.forward) std::reverse(passed->begin() + static_cast<std::ptrdiff_t>(begin), passed->end());
    }
}

} // namespace hachure::animation
