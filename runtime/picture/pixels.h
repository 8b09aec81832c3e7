#pragma once

#include <hachure/runtime/assets/image.h>

#include <algorithm>
#include <cstddef>

namespace hachure::picture {

[[nodiscard]] inline std::size_t pixel_count(const assets::Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Channel of a pixel: bytes on the scale of 0 to 1, floats as they are.
[[nodiscard]] inline double channel(const assets::Image& image, std::size_t pixel, int c) {
    const std::size_t at = pixel * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c);
    return image.type == assets::PixelType::u8 ? image.u8()[at] / 255.0 : static_cast<double>(image.f32()[at]);
}

/// The reverse; bytes are rounded.
inline void set_channel(assets::Image& image, std::size_t pixel, int c, double value) {
    const std::size_t at = pixel * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c);
    if (image.type == assets::PixelType::u8)
        image.u8()[at] = static_cast<std::uint8_t>(std::clamp(255.0 * value + 0.5, 0.0, 255.0));
    else
        image.f32()[at] = static_cast<float>(value);
}

/// Whether a mask lets a pixel be seen: its first channel is one half or more there. Null lets all be seen.
[[nodiscard]] inline bool is_seen(const assets::Image* mask, std::size_t pixel) {
    return !mask || channel(*mask, pixel, 0) >= 0.5;
}

[[nodiscard]] inline bool same_size(const assets::Image& a, const assets::Image& b) {
    return a.width == b.width && a.height == b.height;
}

/// Whether no value is NaN or infinite.
[[nodiscard]] bool all_finite(const assets::Image& image);

} // namespace hachure::picture
