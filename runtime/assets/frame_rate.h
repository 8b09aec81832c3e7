#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace hachure::assets {

/// Frames per second, as an exact fraction: 30/1, 2997/100, 30000/1001.
struct FrameRate {
    int frames = 30; ///< 1 or more
    int seconds = 1; ///< 1 or more

    /// When frame `number` begins, seconds.
    [[nodiscard]] double time_of(std::int64_t number) const {
        return static_cast<double>(number * seconds) / static_cast<double>(frames);
    }

    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// Largest rate that is read, frames per second; the smallest is 1.
inline constexpr int max_frame_rate = 1000;

/// Reads "25", "29.97" (up to six decimals) and "30000/1001", in lowest terms. Nothing when `text` is none of these or
/// the rate is outside [1, max_frame_rate].
[[nodiscard]] std::optional<FrameRate> parse_frame_rate(std::string_view text);

} // namespace hachure::assets
