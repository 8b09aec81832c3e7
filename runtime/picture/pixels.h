#pragma once

#include <hachure/runtime/assets/image.h>

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

[[nodiscard]] inline bool same_size(const assets::Image& a, const assets::Image& b) {
    return a.width == b.width && a.height == b.height;
}

/// Whether no value is NaN or infinite.
[[nodiscard]] bool all_finite(const assets::Image& image);

} // namespace hachure::picture
