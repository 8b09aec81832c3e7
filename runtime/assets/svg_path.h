#pragma once

#include <hachure/runtime/assets/svg_file.h>

#include <span>
#include <string>

namespace hachure::assets {

/// The path of a line that has one width: "M1.00 2.00L3.00 4.00", with "Z" when closed.
[[nodiscard]] std::string svg_path(std::span<const SvgPoint> points, bool closed);

/// The path of the outline of a line whose width varies. Ends that are round get half a circle, others are cut off
/// straight across.
[[nodiscard]] std::string svg_outline(std::span<const SvgPoint> points, bool round_start, bool round_end);

} // namespace hachure::assets
