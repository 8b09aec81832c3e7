#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/abstracted_lines/stroke_textures.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

namespace hachure {
namespace {

float value_at(const assets::Image& image, std::size_t index) {
    return image.type == assets::PixelType::u8 ? static_cast<float>(image.u8()[index]) / 255.0f : image.f32()[index];
}

/// Random numbers by place: the same everywhere.
float random_at(std::uint32_t x, std::uint32_t y, std::uint32_t octave) {
    std::uint32_t h = x * 0x8da6b343u ^ y * 0xd8163841u ^ octave * 0xcb1ab31fu;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return static_cast<float>((h ^ (h >> 16)) >> 8) / 16777216.0f;
}

/// Smooth noise of cells one unit wide, 0 to 1.
float noise(float x, float y, std::uint32_t octave) {
    const float left = std::floor(x), top = std::floor(y);
    const auto i = static_cast<std::uint32_t>(left), j = static_cast<std::uint32_t>(top);
    const float u = glm::smoothstep(0.0f, 1.0f, x - left), v = glm::smoothstep(0.0f, 1.0f, y - top);
    const float above = glm::mix(random_at(i, j, octave), random_at(i + 1, j, octave), u);
    const float below = glm::mix(random_at(i, j + 1, octave), random_at(i + 1, j + 1, octave), u);
    return glm::mix(above, below, v);
}

} // namespace

float StrokeInk::mean() const {
    return std::accumulate(coverage.begin(), coverage.end(), 0.0f) / static_cast<float>(coverage.size());
}

StrokeInk ink_of(const assets::Image& image, const std::filesystem::path& file) {
    StrokeInk ink{image.width, image.height, {}};
    const auto channels = static_cast<std::size_t>(image.channels);
    const bool alpha = channels == 2 || channels == 4;
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < count; ++i) {
        float value = 0.0f;
        if (alpha)
            value = value_at(image, i * channels + channels - 1);
        else
            for (std::size_t c = 0; c < channels; ++c)
                value += (1.0f - value_at(image, i * channels + c)) / static_cast<float>(channels);
        if (!std::isfinite(value)) throw Error(file.string(), "is no stroke: it has values that are not finite");
        ink.coverage.push_back(std::clamp(value, 0.0f, 1.0f));
    }
    return ink;
}

StrokeInk dry_ink() {
    StrokeInk ink{256, 32, {}};
    for (int row = 0; row < ink.height; ++row) {
        for (int column = 0; column < ink.width; ++column) {
            const auto x = static_cast<float>(column), y = static_cast<float>(row);
            // Streaks, specks and slow changes of pressure.
            const float grain = 0.45f * noise(x / 14.0f, y / 5.0f, 0) + 0.35f * noise(x / 5.0f, y / 3.0f, 1) +
                                0.2f * noise(x / 48.0f, y / 32.0f, 2);
            const float rim = std::abs((y + 0.5f) / static_cast<float>(ink.height) * 2.0f - 1.0f);
            const float dryness = 0.62f - 0.16f * rim * rim;
            ink.coverage.push_back(1.0f - glm::smoothstep(dryness - 0.12f, dryness + 0.16f, grain));
        }
    }
    return ink;
}

const StrokeTexture& StrokeTextures::get(const std::string& file) {
    const auto found = textures_.find(file);
    if (found != textures_.end()) return found->second;
    StrokeInk ink;
    if (file.empty()) {
        ink = dry_ink();
    } else {
        const assets::Image image = assets::read_image(file);
        if (image.width > max_stroke_columns || image.height > max_stroke_rows)
            throw Error(file, fmt::format("is too large for a stroke: {}x{}, at most {}x{}", image.width, image.height,
                                          max_stroke_columns, max_stroke_rows));
        ink = ink_of(image, file);
    }
    StrokeTexture made{gpu::Texture({.width = ink.width,
                                     .height = ink.height,
                                     .format = gpu::Format::r16f,
                                     .levels = gpu::mip_levels(ink.width, ink.height)},
                                    "stroke"),
                       ink.mean()};
    made.texture.upload(std::span<const float>(ink.coverage));
    made.texture.generate_mipmaps();
    made.texture.set_sampling({.mipmaps = true, .wrap_u = gpu::Wrap::mirrored_repeat});
    return textures_.emplace(file, std::move(made)).first->second;
}

} // namespace hachure
