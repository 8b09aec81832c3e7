#pragma once

#include <hachure/editor/play/play_result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hachure::play {

/// A figure of values over frames: the line, its limits with what is not allowed hatched, and the frames outside them
/// shaded. The page's scripts add a cursor that tells the values.
[[nodiscard]] std::string html_curve(const Curve& curve);

/// The frames whose values lie outside its limits, ascending; what is no number does where there are limits.
[[nodiscard]] std::vector<std::int64_t> frames_outside(const Curve& curve);

} // namespace hachure::play
