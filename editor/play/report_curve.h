#pragma once

#include <hachure/editor/play/play_result.h>

#include <string>

namespace hachure::play {

/// A figure of values over frames: the line, its limits with what is not allowed hatched, and the frames outside them
/// shaded. The page's scripts add a cursor that tells the values.
[[nodiscard]] std::string html_curve(const Curve& curve);

/// How many of its values lie outside its limits; what is no number does where there are limits.
[[nodiscard]] std::size_t values_outside(const Curve& curve);

} // namespace hachure::play
