#pragma once

#include <hachure/runtime/assets/image.h>

namespace hachure::picture {

/// Where two pictures of one size differ, for people: u8, RGB; each channel the difference of that channel times
/// `gain`, so that black is equal. A grey copy of `a` at an eighth of its brightness shows where one is. NaN is white.
/// Pictures as for compare_pictures, with 1 or more channels; buffers of other units are scaled by `gain` alone.
[[nodiscard]] assets::Image difference_picture(const assets::Image& a, const assets::Image& b, double gain = 8.0);

/// The picture at most `max_width` pixels wide: every new pixel is the mean of what it covers. u8; unchanged when it is
/// not wider than that.
[[nodiscard]] assets::Image shrunk(const assets::Image& picture, int max_width);

} // namespace hachure::picture
