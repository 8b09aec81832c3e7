#pragma once

#include <hachure/runtime/assets/image.h>

#include <optional>

struct AVFrame;

namespace hachure::assets {

/// A decoded frame as u8 RGB of that size: Y'CbCr by the matrix and range that the frame says (where it does not,
/// BT.709 above 576 rows, else BT.601), chroma interpolated from where it sits; RGB, grey and palettes as they are.
/// Alpha is left out. Nothing for pixels that are not in memory, or for a frame of another size.
[[nodiscard]] std::optional<Image> video_pixels(const AVFrame& frame, int width, int height);

} // namespace hachure::assets
