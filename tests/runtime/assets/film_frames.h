#pragma once

#include <hachure/runtime/assets/image.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hachure::test {

/// A frame of one colour.
inline assets::Image plain_frame(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        image.u8()[i] = red, image.u8()[i + 1] = green, image.u8()[i + 2] = blue;
    return image;
}

inline void set_pixel(assets::Image& image, int x, int y, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    std::uint8_t* p = image.u8() + 3 * static_cast<std::size_t>(y * image.width + x);
    p[0] = red, p[1] = green, p[2] = blue;
}

/// A drawing: on white, a disc of cool to warm tones with a dark outline, which moves with `number`. It has thousands
/// of colours.
inline assets::Image drawn_frame(int width, int height, int number) {
    assets::Image image = plain_frame(width, height, 255, 255, 255);
    const double radius = 0.35 * std::min(width, height), middle_x = 0.4 * width + number, middle_y = 0.5 * height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double dx = (x - middle_x) / radius, dy = (y - middle_y) / radius,
                         away = std::sqrt(dx * dx + dy * dy);
            if (away > 1.0) continue;
            const double warm = 0.5 + 0.5 * dx, light = 0.5 - 0.3 * dy;
            if (away > 0.93)
                set_pixel(image, x, y, 16, 16, 24);
            else
                set_pixel(image, x, y, static_cast<std::uint8_t>(255 * light * (0.4 + 0.6 * warm)),
                          static_cast<std::uint8_t>(255 * light * 0.8),
                          static_cast<std::uint8_t>(255 * light * (1.0 - 0.6 * warm)));
        }
    return image;
}

/// Largest and root mean square difference of two images' bytes; the part that both have, from the top left.
struct Difference {
    int largest = 0;
    double rms = 0;
};

inline Difference difference(const assets::Image& a, const assets::Image& b) {
    const int width = std::min(a.width, b.width), height = std::min(a.height, b.height);
    Difference result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 3 * width; ++x) {
            const int d = std::abs(a.u8()[3 * a.width * y + x] - b.u8()[3 * b.width * y + x]);
            result.largest = std::max(result.largest, d);
            result.rms += d * d;
        }
    result.rms = std::sqrt(result.rms / (3.0 * width * height));
    return result;
}

} // namespace hachure::test
