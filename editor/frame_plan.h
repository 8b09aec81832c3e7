#pragma once

#include <hachure/runtime/assets/frame_rate.h>

#include <cstdint>
#include <optional>
#include <string>

namespace hachure {

/// Which frames are drawn, and the moment that each of them shows.
struct FramePlan {
    std::int64_t first = 0, last = 0; ///< frames, both of them included; 0 <= first <= last
    assets::FrameRate rate;
    bool numbered = false;      ///< `--frames` was given
    std::optional<double> time; ///< of `--time`: what the only frame shows, seconds

    [[nodiscard]] std::int64_t count() const { return last - first + 1; }

    /// What frame `number` shows, seconds: number / rate, wherever the plan begins.
    [[nodiscard]] double seconds(std::int64_t number) const { return time ? *time : rate.time_of(number); }
};

/// From the texts of `--frames` ("A..B" or "A"), `--time` and `--fps`; the first two may be empty, and one is. Throws
/// UsageError.
[[nodiscard]] FramePlan parse_frame_plan(const std::string& frames, const std::string& time, const std::string& fps);

} // namespace hachure
