#include <hachure/runtime/assert.h>
#include <hachure/runtime/picture/difference_picture.h>
#include <hachure/runtime/picture/pixels.h>

#include <algorithm>
#include <cmath>

namespace hachure::picture {
namespace {

/// Brightness between 0 and 1, whatever the picture holds.
double dim(const assets::Image& image, std::size_t pixel) {
    double sum = 0.0;
    for (int c = 0; c < image.channels; ++c) sum += channel(image, pixel, c);
    const double mean = sum / image.channels;
    return std::isfinite(mean) ? std::clamp(mean, 0.0, 1.0) / 8.0 : 0.0;
}

/// The part of [begin, end) that pixel i of `count` new pixels covers, over `size` old ones.
struct Cover {
    double begin, end;
    Cover(int i, int count, int size)
        : begin(static_cast<double>(i) * size / count), end(static_cast<double>(i + 1) * size / count) {}
    [[nodiscard]] int first() const { return static_cast<int>(begin); }
    [[nodiscard]] int last(int size) const { return std::min(size - 1, static_cast<int>(std::ceil(end)) - 1); }
    [[nodiscard]] double weight(int pixel) const { return std::min(end, pixel + 1.0) - std::max<double>(begin, pixel); }
};

} // namespace

assets::Image difference_picture(const assets::Image& a, const assets::Image& b, double gain) {
    HACHURE_ASSERT(same_size(a, b), "pictures of one size are compared");
    assets::Image result = assets::make_image(a.width, a.height, 3, assets::PixelType::u8);
    const int channels = std::min({a.channels, b.channels, 3});
    for (std::size_t i = 0; i < pixel_count(a); ++i) {
        const double ground = dim(a, i);
        for (int c = 0; c < 3; ++c) {
            const int from = std::min(c, channels - 1);
            const double off = gain * std::abs(channel(a, i, from) - channel(b, i, from));
            set_channel(result, i, c, std::isfinite(off) ? std::max(off, ground) : 1.0);
        }
    }
    return result;
}

assets::Image shrunk(const assets::Image& picture, int max_width) {
    HACHURE_ASSERT(picture.type == assets::PixelType::u8 && max_width >= 1, "bytes are shrunk, to something");
    if (picture.width <= max_width) return picture;
    const int height =
        std::max(1, static_cast<int>(static_cast<std::int64_t>(picture.height) * max_width / picture.width));
    assets::Image result = assets::make_image(max_width, height, picture.channels, assets::PixelType::u8);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < max_width; ++x)
            for (int c = 0; c < picture.channels; ++c) {
                const Cover rows(y, height, picture.height), columns(x, max_width, picture.width);
                double sum = 0.0, weight = 0.0;
                for (int v = rows.first(); v <= rows.last(picture.height); ++v)
                    for (int u = columns.first(); u <= columns.last(picture.width); ++u) {
                        const double part = rows.weight(v) * columns.weight(u);
                        sum += part * channel(picture, static_cast<std::size_t>(v) * picture.width + u, c);
                        weight += part;
                    }
                set_channel(result, static_cast<std::size_t>(y) * max_width + x, c, sum / weight);
            }
    return result;
}

} // namespace hachure::picture
