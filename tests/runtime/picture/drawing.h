#pragma once

#include <hachure/runtime/assets/image.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace hachure::test {

inline constexpr int width = 160, height = 120;

inline assets::Image filled(std::array<std::uint8_t, 3> color) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    for (int i = 0; i < width * height; ++i) std::ranges::copy(color, image.u8() + 3 * i);
    return image;
}

inline void set(assets::Image& image, int x, int y, std::uint8_t value) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    std::fill_n(image.u8() + 3 * (y * width + x), 3, value);
}

/// Two lines, 2 px wide, over a ramp.
inline assets::Image drawing(int shift, bool second_line) {
    assets::Image image = filled({});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) set(image, x, y, static_cast<std::uint8_t>(150 + x / 2));
    for (int t = 10; t < 60; ++t)
        for (int w = 0; w < 2; ++w) {
            set(image, 20 + t + shift, 30 + w + t / 2, 0);
            if (second_line) set(image, 110 + w + shift, 20 + t, 0);
        }
    return image;
}

} // namespace hachure::test
