#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/yuv420.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure::assets {
namespace {

constexpr int fraction_bits = 18; // sums of eight bytes times a coefficient stay below 2^31
constexpr double red_weight = 0.2126, green_weight = 0.7152, blue_weight = 0.0722;
constexpr int chroma_taps = 8; // the weights of the chroma filter add up to it

/// Coefficients of R, G, B in fixed point.
struct Weights {
    int red, green, blue;
};

constexpr int fixed(double value) { return static_cast<int>(value * (1 << fraction_bits) + (value < 0 ? -0.5 : 0.5)); }

constexpr Weights luma_of_rgb{fixed(red_weight * 219 / 255), fixed(green_weight * 219 / 255),
                              fixed(blue_weight * 219 / 255)};

/// Of (colour - luma) / (2 (1 - weight of the colour)), in 224 steps; grey has none of it, exactly.
constexpr Weights chroma_weights(double red, double green, double blue, double own) {
    const double scale = 224.0 / 255 / (2 * (1 - own)) / chroma_taps;
    Weights weights{fixed((red - red_weight) * scale), fixed((green - green_weight) * scale), 0};
    weights.blue = fixed((blue - blue_weight) * scale);
    weights.green = -weights.red - weights.blue;
    return weights;
}

constexpr Weights blue_difference = chroma_weights(0, 0, 1, blue_weight);
constexpr Weights red_difference = chroma_weights(1, 0, 0, red_weight);

constexpr int half = 1 << (fraction_bits - 1);

std::uint8_t apply(const Weights& weights, const int* rgb, int offset) {
    const int sum = weights.red * rgb[0] + weights.green * rgb[1] + weights.blue * rgb[2];
    return static_cast<std::uint8_t>(offset + ((sum + half) >> fraction_bits));
}

/// The start of row `y`, or of the last row.
const std::uint8_t* row_of(const ConvertToYuv420& job, int y) {
    const std::size_t row = static_cast<std::size_t>(std::min(y, job.height - 1));
    return job.pixels.data() + row * static_cast<std::size_t>(job.width) * static_cast<std::size_t>(job.channels);
}

void convert_luma(const ConvertToYuv420& job, int y) {
    const std::uint8_t* from = row_of(job, y);
    std::uint8_t* to = job.luma.bytes.data() + static_cast<std::size_t>(y) * job.luma.stride;
    for (int x = 0; x < job.width; ++x, from += job.channels) {
        const int rgb[3]{from[0], from[1], from[2]};
        to[x] = apply(luma_of_rgb, rgb, 16);
    }
    if (job.width % 2 != 0) to[job.width] = to[job.width - 1];
}

void convert_chroma(const ConvertToYuv420& job, int y) {
    const std::array<const std::uint8_t*, 2> rows{row_of(job, 2 * y), row_of(job, 2 * y + 1)};
    std::uint8_t* blue = job.blue.bytes.data() + static_cast<std::size_t>(y) * job.blue.stride;
    std::uint8_t* red = job.red.bytes.data() + static_cast<std::size_t>(y) * job.red.stride;
    for (int x = 0; x < job.width; x += 2) {
        const int before = std::max(x - 1, 0) * job.channels, at = x * job.channels;
        const int behind = std::min(x + 1, job.width - 1) * job.channels;
        int rgb[3]{};
        for (const std::uint8_t* row : rows)
            for (int c = 0; c < 3; ++c) rgb[c] += row[before + c] + 2 * row[at + c] + row[behind + c];
        blue[x / 2] = apply(blue_difference, rgb, 128);
        red[x / 2] = apply(red_difference, rgb, 128);
    }
}

bool fits(const BytePlane& plane, int width, int height) {
    const auto row = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    return plane.stride >= row && plane.bytes.size() >= plane.stride * (rows - 1) + row;
}

} // namespace

void ConvertToYuv420::validate() const {
    HACHURE_ASSERT(width >= 1 && height >= 1 && (channels == 3 || channels == 4), "the image has RGB pixels");
    HACHURE_ASSERT(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                        static_cast<std::size_t>(channels),
                   "the image has all its pixels");
    const int wide = even_size(width), high = even_size(height);
    HACHURE_ASSERT(fits(luma, wide, high), "the luma plane has room");
    HACHURE_ASSERT(fits(blue, wide / 2, high / 2) && fits(red, wide / 2, high / 2), "the chroma planes have room");
}

void ConvertToYuv420::run() const {
    for (int y = 0; y < even_size(height); ++y) convert_luma(*this, y);
    for (int y = 0; y < even_size(height) / 2; ++y) convert_chroma(*this, y);
}

} // namespace hachure::assets
