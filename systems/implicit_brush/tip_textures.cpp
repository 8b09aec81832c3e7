#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/implicit_brush/tip_textures.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace hachure {
namespace {

using Pixel = std::array<float, 4>;

float decoded(float srgb) { return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f); }

/// Red, green, blue as stored, and alpha (1 where there is none).
Pixel pixel_at(const assets::Image& image, std::size_t index) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const auto value = [&](std::size_t channel) {
        const std::size_t i = index * channels + channel;
        return image.type == assets::PixelType::u8 ? static_cast<float>(image.u8()[i]) / 255.0f : image.f32()[i];
    };
    const bool colors = channels >= 3;
    return {value(0), value(colors ? 1 : 0), value(colors ? 2 : 0),
            channels == 2 || channels == 4 ? value(channels - 1) : 1.0f};
}

bool has_alpha(const assets::Image& image) { return image.channels == 2 || image.channels == 4; }

bool is_grey(const Pixel& pixel) {
    const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
    return (most - least) * pixel[3] < 0.02f;
}

} // namespace

float TipImage::mean() const {
    double sum = 0.0;
    for (std::size_t i = 3; i < pixels.size(); i += 4) sum += double(pixels[i]);
    return static_cast<float>(sum / (double(width) * double(height)));
}

TipImage tip_of(const assets::Image& image, const std::filesystem::path& file) {
    TipImage tip{image.width, image.height, false, {}};
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const bool alpha = has_alpha(image);
    for (std::size_t i = 0; i < count; ++i) {
        const Pixel pixel = pixel_at(image, i);
        if (!std::ranges::all_of(pixel, [](float v) { return std::isfinite(v); }))
            throw Error(file.string(), "is no brush tip: it has values that are not finite");
        tip.colored = tip.colored || (alpha && !is_grey(pixel));
        const float dark = 1.0f - (pixel[0] + pixel[1] + pixel[2]) / 3.0f;
        const float opacity = std::clamp(alpha ? pixel[3] : dark, 0.0f, 1.0f);
        for (int c = 0; c < 3; ++c) {
            const float color = std::max(pixel[static_cast<std::size_t>(c)], 0.0f);
            tip.pixels.push_back(opacity * (image.type == assets::PixelType::u8 ? decoded(color) : color));
        }
        tip.pixels.push_back(opacity);
    }
    if (!(tip.mean() > 1e-4f)) throw Error(file.string(), "is no brush tip: it is clear all over");
    return tip;
}

TipBitmap make_tip_bitmap(const TipImage& image) {
    TipBitmap made{gpu::Texture({.width = image.width,
                                 .height = image.height,
                                 .format = gpu::Format::rgba16f,
                                 .levels = gpu::mip_levels(image.width, image.height)},
                                "brush tip"),
                   image.colored, image.mean()};
    made.texture.upload(std::span<const float>(image.pixels));
    made.texture.generate_mipmaps();
    made.texture.set_sampling({.mipmaps = true});
    return made;
}

const TipBitmap& TipTextures::get(const std::string& file) {
    const auto found = textures_.find(file);
    if (found != textures_.end()) return found->second;
    if (file.empty()) throw Error("implicit_brush.tip_file", "is empty: tip bitmap needs a picture");
    const assets::Image image = assets::read_image(file);
    if (image.width > max_tip_size || image.height > max_tip_size)
        throw Error(file, fmt::format("is too large for a brush tip: {}x{}, at most {}x{}", image.width, image.height,
                                      max_tip_size, max_tip_size));
    return textures_.emplace(file, make_tip_bitmap(tip_of(image, file))).first->second;
}

} // namespace hachure
