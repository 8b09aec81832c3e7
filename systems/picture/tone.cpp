#include <hachure/runtime/parallel.h>
#include <hachure/systems/picture/tone.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure {
namespace {

constexpr double red = 0.2126, green = 0.7152, blue = 0.0722; // Rec. 709
constexpr float largest_half = 65504.0f;

double linear_from_srgb(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

double srgb_from_linear(double light) {
    const double y = std::clamp(light, 0.0, 1.0);
    return y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1.0 / 2.4) - 0.055;
}

const std::array<double, 256>& linear_bytes() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = linear_from_srgb(double(i) / 255.0);
        return values;
    }();
    return table;
}

/// Channels 1 to 4: grey, grey and alpha, RGB, RGBA.
struct Layout {
    explicit Layout(const assets::Image& image)
        : channels(static_cast<std::size_t>(image.channels)), colored(image.channels >= 3),
          alpha(image.channels == 2 || image.channels == 4) {}

    std::size_t channels;
    bool colored, alpha;
};

float tone_of(const std::uint8_t* pixel, const Layout& layout) {
    const std::uint8_t r = pixel[0], g = pixel[layout.colored ? 1 : 0], b = pixel[layout.colored ? 2 : 0];
    const double a = layout.alpha ? pixel[layout.channels - 1] / 255.0 : 1.0;
    // What the curve there and back would give, but for its rounding.
    if (r == g && g == b && a == 1.0) return static_cast<float>(r) / 255.0f;
    const auto& linear = linear_bytes();
    return static_cast<float>(
        srgb_from_linear(a * (red * linear[r] + green * linear[g] + blue * linear[b]) + (1.0 - a)));
}

float tone_of(const float* pixel, const Layout& layout) {
    const double r = pixel[0], g = pixel[layout.colored ? 1 : 0], b = pixel[layout.colored ? 2 : 0];
    const double a = layout.alpha ? std::clamp(double(pixel[layout.channels - 1]), 0.0, 1.0) : 1.0;
    return static_cast<float>(srgb_from_linear(red * r + green * g + blue * b + (1.0 - a)));
}

/// Calls `body(pixel index)` for all pixels, rows beside each other.
template <class Body> void for_pixels(const assets::Image& image, Body body) {
    const auto width = static_cast<std::size_t>(image.width);
    parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t row) {
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) body(i);
    });
}

std::size_t pixel_count(const assets::Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

} // namespace

std::vector<float> picture_tones(const assets::Image& image) {
    const Layout layout(image);
    std::vector<float> tones(pixel_count(image));
    if (image.type == assets::PixelType::u8)
        for_pixels(image, [&](std::size_t i) { tones[i] = tone_of(image.u8() + i * layout.channels, layout); });
    else
        for_pixels(image, [&](std::size_t i) { tones[i] = tone_of(image.f32() + i * layout.channels, layout); });
    return tones;
}

std::vector<float> premultiplied_colors(const assets::Image& image) {
    const Layout layout(image);
    const bool bytes = image.type == assets::PixelType::u8;
    std::vector<float> colors(4 * pixel_count(image));
    for_pixels(image, [&](std::size_t i) {
        const std::size_t last = (i + 1) * layout.channels - 1;
        float alpha = 1.0f;
        if (layout.alpha) alpha = bytes ? float(image.u8()[last]) / 255.0f : std::clamp(image.f32()[last], 0.0f, 1.0f);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = i * layout.channels + (layout.colored ? c : 0);
            colors[4 * i + c] = bytes ? alpha * static_cast<float>(linear_bytes()[image.u8()[at]])
                                      : std::clamp(image.f32()[at], -largest_half, largest_half);
        }
        colors[4 * i + 3] = alpha;
    });
    return colors;
}

} // namespace hachure
