#pragma once

#include <cstddef>
#include <cstdint>

namespace hachure::animation {

enum class LoopMode : std::uint8_t {
    once,      ///< stops at the end
    loop,      ///< begins again
    ping_pong, ///< turns round at both ends
};

/// How a clip is played. Everything below is a function of this and the playing time, never of the steps that led
/// there. All times are seconds, finite.
struct Playback {
    double duration = 0.0; ///< of the clip, at least 0
    /// Seconds of the clip per second. When negative, the clip is played mirrored in time: from its end to its start.
    double speed = 1.0;
    LoopMode mode = LoopMode::loop;
    /// Seconds of the clip that count as played when playing begins. With `once` a negative one delays the start.
    double offset = 0.0;

    friend bool operator==(const Playback&, const Playback&) = default;
};

/// A playing time at which playing has not begun. Playing begins at time 0; any negative time says the same.
inline constexpr double not_started = -1.0;

/// The time in the clip, [0, duration], after playing for `time`. The end of a clip in `loop` is its start again (its
/// end, when played backwards).
[[nodiscard]] double clip_time(const Playback& playback, double time);

/// Whether the clip moves on no more: `once`, and at its end.
[[nodiscard]] bool finished(const Playback& playback, double time);

/// The same playback with another speed from playing time `time` on, its clip time unbroken there. A change of sign
/// turns the direction round.
[[nodiscard]] Playback with_speed(const Playback& playback, double time, double speed);

/// Where a playback is: how often it has come to an end, and the clip seconds since. `local` in [0, duration).
/// `once` stays in cycle 0 with `local` in [0, duration].
struct PlaybackPlace {
    double cycle = 0.0;  ///< a whole number; negative with a negative offset
    double local = 0.0;  ///< seconds in the direction of play
    bool forward = true; ///< whether the clip time is `local`, or else duration - local

    friend bool operator==(const PlaybackPlace&, const PlaybackPlace&) = default;
};
[[nodiscard]] PlaybackPlace playback_place(const Playback& playback, double time);

/// A stretch of clip time that was passed, in the direction of play: `from` > `to` when played backwards.
struct ClipInterval {
    double from = 0.0;
    double to = 0.0;
    bool includes_from = false;
    bool includes_to = false;
    double cycle = 0.0;  ///< of the PlaybackPlace
    bool forward = true; ///< of the PlaybackPlace: whether clip time increases

    /// Whether the moment lies in it.
    [[nodiscard]] bool contains(double time) const;
};

/// What was passed after playing time `from`, up to and including `to`: one stretch per cycle, in order. However a time
/// is divided into steps, each moment of the clip is in exactly as many stretches. When `from` is negative, the moment
/// at which playing begins counts as well. Turning points of `ping_pong` count once; where `loop` wraps, both the end
/// and the start are passed. Playing time that runs backwards passes nothing.
///
///     for (PassedIntervals passed(playback, from, to); passed.next();) use(passed.interval());
class PassedIntervals {
public:
    PassedIntervals(const Playback& playback, double from, double to);

    /// Moves to the next stretch; false when there is none left.
    bool next();
    [[nodiscard]] const ClipInterval& interval() const { return interval_; }

    /// A step that passes more cycles than this gives the last ones.
    static constexpr double most_cycles = 1000.0;

private:
    Playback playback_;
    PlaybackPlace start_;
    PlaybackPlace end_;
    double cycle_ = 0.0; ///< the next one to give
    bool includes_start_ = false;
    bool done_ = false;
    ClipInterval interval_;
};

} // namespace hachure::animation
