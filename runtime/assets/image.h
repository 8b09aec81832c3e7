#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure::assets {

enum class PixelType : std::uint8_t {
    u8,  ///< 8 bits a channel, [0, 255]; colour channels are sRGB-encoded unless the user of the image knows better
    f32, ///< 32-bit float, linear, any range
};

/// Decoded pixels in memory: rows from top to bottom, channels interleaved, no padding.
struct Image {
    int width = 0;    ///< pixels, >= 1 when valid
    int height = 0;   ///< pixels, >= 1 when valid
    int channels = 0; ///< 1 to 4
    PixelType type = PixelType::u8;
    std::vector<std::byte> pixels; ///< width * height * channels * (1 or 4) bytes

    [[nodiscard]] std::size_t bytes_per_channel() const { return type == PixelType::u8 ? 1 : 4; }
    [[nodiscard]] std::size_t row_bytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) * bytes_per_channel();
    }
    [[nodiscard]] std::uint8_t* u8() { return reinterpret_cast<std::uint8_t*>(pixels.data()); }
    [[nodiscard]] const std::uint8_t* u8() const { return reinterpret_cast<const std::uint8_t*>(pixels.data()); }
    [[nodiscard]] float* f32() { return reinterpret_cast<float*>(pixels.data()); }
    [[nodiscard]] const float* f32() const { return reinterpret_cast<const float*>(pixels.data()); }
};

/// An image of the given shape with every byte zero.
[[nodiscard]] inline Image make_image(int width, int height, int channels, PixelType type) {
    Image image{width, height, channels, type, {}};
    image.pixels.resize(image.row_bytes() * static_cast<std::size_t>(height));
    return image;
}

} // namespace hachure::assets
