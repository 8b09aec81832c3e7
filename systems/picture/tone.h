#pragma once

#include <hachure/runtime/assets/image.h>

#include <vector>

namespace hachure {

/// The tone of every pixel (components/picture.h), rows from top to bottom. Float images are finite.
[[nodiscard]] std::vector<float> picture_tones(const assets::Image& image);

/// RGBA of every pixel, linear, multiplied by alpha, rows from top to bottom. Alpha of 8-bit images is not multiplied
/// into their colours, that of float images is, as PNG and EXR have it. Colours are cut to what half floats hold.
[[nodiscard]] std::vector<float> premultiplied_colors(const assets::Image& image);

} // namespace hachure
