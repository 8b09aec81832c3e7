#pragma once

#include <hachure/runtime/assets/image.h>

#include <cstddef>

namespace hachure::assets {

/// Brightness of a texel (row * width + column): the weighted mean of its colours as they are encoded (Rec. 709's
/// luma), 8 bits as [0, 1]; the first channel where there are fewer than three. Alpha does not count.
[[nodiscard]] inline float image_luma(const Image& image, std::size_t texel) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const auto value = [&](std::size_t channel) {
        const std::size_t at = texel * channels + channel;
        return image.type == PixelType::u8 ? static_cast<float>(image.u8()[at]) / 255.0f : image.f32()[at];
    };
    return channels >= 3 ? 0.2126f * value(0) + 0.7152f * value(1) + 0.0722f * value(2) : value(0);
}

} // namespace hachure::assets
