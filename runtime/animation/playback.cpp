#include <hachure/runtime/animation/playback.h>
#include <hachure/runtime/assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::animation {
namespace {

/// Clip seconds played, in the direction of play.
double travelled(const Playback& playback, double time) {
    HACHURE_ASSERT(std::isfinite(time) && std::isfinite(playback.speed) && std::isfinite(playback.offset) &&
                       playback.duration >= 0.0 && std::isfinite(playback.duration),
                   "playback is finite");
    constexpr double most = std::numeric_limits<double>::max();
    return std::clamp(playback.offset + std::abs(playback.speed) * std::max(time, 0.0), -most, most);
}

bool is_odd(double whole) { return std::fmod(whole, 2.0) != 0.0; }

double clip_time_of(const Playback& playback, const PlaybackPlace& place) {
    return place.forward ? place.local : playback.duration - place.local;
}

} // namespace

PlaybackPlace playback_place(const Playback& playback, double time) {
    const double distance = travelled(playback, time), duration = playback.duration;
    PlaybackPlace place;
    place.forward = !(playback.speed < 0.0);
    if (playback.mode == LoopMode::once || duration == 0.0) {
        place.local = std::clamp(distance, 0.0, duration);
        return place;
    }
    // std::fmod is exact, so places are ordered as the distances are, and equal ones are equal.
    place.local = std::fmod(distance, duration);
    if (place.local < 0.0) place.local = std::min(place.local + duration, std::nextafter(duration, 0.0));
    place.cycle = std::round((distance - place.local) / duration);
    if (playback.mode == LoopMode::ping_pong && is_odd(place.cycle)) place.forward = !place.forward;
    return place;
}

double clip_time(const Playback& playback, double time) {
    return clip_time_of(playback, playback_place(playback, time));
}

bool finished(const Playback& playback, double time) {
    return playback.mode == LoopMode::once && travelled(playback, time) >= playback.duration;
}

Playback with_speed(const Playback& playback, double time, double speed) {
    Playback result = playback;
    result.speed = speed;
    double distance = travelled(playback, time);
    if ((speed < 0.0) != (playback.speed < 0.0)) {
        const PlaybackPlace place = playback_place(playback, time);
        distance = playback.duration - place.local;
        if (playback.mode == LoopMode::ping_pong && is_odd(place.cycle)) distance += playback.duration;
    }
    result.offset = distance - std::abs(speed) * std::max(time, 0.0);
    return result;
}

bool ClipInterval::contains(double time) const {
    const double low = std::min(from, to), high = std::max(from, to);
    if (time < low || time > high) return false;
    return (time != from || includes_from) && (time != to || includes_to);
}

PassedIntervals::PassedIntervals(const Playback& playback, double from, double to)
    : playback_(playback), start_(playback_place(playback, from)), end_(playback_place(playback, to)) {
    done_ = to < 0.0 || from >= to;
    includes_start_ = from < 0.0;
    if (playback.mode == LoopMode::once) {
        // A start that is delayed is passed when its time has come.
        const bool begun = from >= 0.0 && travelled(playback, from) >= 0.0;
        includes_start_ = !begun && travelled(playback, to) >= 0.0;
    }
    cycle_ = start_.cycle;
    if (end_.cycle - cycle_ > most_cycles) cycle_ = end_.cycle - most_cycles;
}

bool PassedIntervals::next() {
    while (!done_) {
        const bool first = cycle_ == start_.cycle, last = cycle_ == end_.cycle;
        const bool mirrored = playback_.mode == LoopMode::ping_pong && is_odd(cycle_ - start_.cycle);
        const PlaybackPlace from{cycle_, first ? start_.local : 0.0, start_.forward != mirrored};
        const PlaybackPlace to{cycle_, last ? end_.local : playback_.duration, from.forward};
        const bool includes_from = first ? includes_start_ : playback_.mode == LoopMode::loop;
        interval_ = {
            clip_time_of(playback_, from), clip_time_of(playback_, to), includes_from, true, cycle_, from.forward};
        // Beyond 2^53 cycles adding one changes nothing.
        done_ = last || cycle_ + 1.0 == cycle_;
        cycle_ += 1.0;
        if (includes_from || from.local < to.local) return true;
    }
    return false;
}

} // namespace hachure::animation
