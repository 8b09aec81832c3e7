#pragma once

#include <hachure/editor/assignments.h>
#include <hachure/runtime/assets/frame_rate.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace hachure {

/// How long an input is that has frames of its own.
struct InputFilm {
    assets::FrameRate rate; ///< its own
    double seconds = 0;     ///< of all its frames

    /// Frames of another rate that show all of it; 1 or more.
    [[nodiscard]] std::int64_t frames_at(const assets::FrameRate& other) const;
};

/// Of a video, at its own rate (30 where it does not say), and of numbered images, at the rate that a `--set
/// picture.frames_per_second` gives them, or else their default. Nothing of other inputs. Throws Error.
[[nodiscard]] std::optional<InputFilm> input_film(const std::filesystem::path& input,
                                                  std::span<const Assignment> assignments);

} // namespace hachure
