#pragma once

#include <hachure/components/paper.h>

#include <cstdint>
#include <vector>

namespace hachure {

/// Texels a side of the relief of a PaperKind: larger than the pictures that are usual, so that no repeat is seen.
inline constexpr int grain_tile = 1024;

/// Heights of a kind of paper, a texel a pixel, row after row; any scale and offset, larger is higher. The tile repeats
/// without a seam, and holds no detail that pixels are too coarse for. `scale` as Paper::scale, in pixels. Depends on
/// its arguments alone, not on threads.
[[nodiscard]] std::vector<float> paper_grain(PaperKind kind, float scale, std::uint32_t seed);

} // namespace hachure
