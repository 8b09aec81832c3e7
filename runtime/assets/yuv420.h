#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hachure::assets {

/// Rows of bytes, `stride` bytes apart.
struct BytePlane {
    std::span<std::uint8_t> bytes;
    std::size_t stride = 0;
};

/// Job: sRGB pixels to Y'CbCr as video has it: 8 bits, limited range ([16, 235], [16, 240]), the matrix of BT.709
/// (ITU-R BT.709-6, items 3.2 to 3.5), chroma at half size, sited at the left pixel of each pair, between its two rows.
/// The curve of the values stays sRGB's. Chroma is filtered with 1 2 1 across and 1 1 down; what lies outside is the
/// nearest pixel inside. Within 0.51 of the exact values.
struct ConvertToYuv420 {
    std::span<const std::uint8_t> pixels; ///< `channels` bytes a pixel, of which the first three are used; no padding
    int width = 0;                        ///< of `pixels`, >= 1
    int height = 0;                       ///< of `pixels`, >= 1
    int channels = 3;                     ///< 3 or 4

    BytePlane luma;        ///< even_size(width) x even_size(height); what is added repeats the edge
    BytePlane blue, red;   ///< half of that in both directions
    void validate() const; ///< asserts that the spans fit the sizes
    void run() const;
};

/// The next even number.
[[nodiscard]] constexpr int even_size(int size) { return size + size % 2; }

} // namespace hachure::assets
