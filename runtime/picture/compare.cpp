#include <hachure/runtime/assert.h>
#include <hachure/runtime/picture/compare.h>
#include <hachure/runtime/picture/flip.h>
#include <hachure/runtime/picture/line_distance.h>
#include <hachure/runtime/picture/percentile.h>
#include <hachure/runtime/picture/pixels.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hachure::picture {
namespace {

/// `b` with the pixels of `a` wherever the mask hides them.
assets::Image filled_from(const assets::Image& a, assets::Image b, const assets::Image& mask) {
    for (std::size_t i = 0; i < pixel_count(b); ++i)
        for (int c = 0; c < 3 && !is_seen(&mask, i); ++c) set_channel(b, i, c, channel(a, i, c));
    return b;
}

/// `b` with the pixels of `a` wherever no channel is more than a rounding step off. A flat surface whose colour lies
/// between two steps is rounded to either by processors that add in another order: all of it, which no percentile
/// leaves out.
assets::Image without_rounding(const assets::Image& a, assets::Image b) {
    for (std::size_t i = 0; i < pixel_count(b); ++i) {
        double largest = 0.0;
        for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(channel(a, i, c) - channel(b, i, c)));
        for (int c = 0; c < 3 && 255.0 * largest <= rounding_step; ++c) set_channel(b, i, c, channel(a, i, c));
    }
    return b;
}

/// The largest difference, and the share of pixels that differ by more than the step.
struct Steps {
    double largest = 0.0, fraction = 0.0;
};

Steps steps_between(const assets::Image& a, const assets::Image& b, int channels, double scale,
                    const CompareOptions& options) {
    Steps result;
    std::size_t differing = 0, seen = 0;
    for (std::size_t i = 0; i < pixel_count(a); ++i) {
        if (!is_seen(options.mask, i)) continue;
        double largest = 0.0;
        for (int c = 0; c < channels; ++c)
            largest = std::max(largest, scale * std::abs(channel(a, i, c) - channel(b, i, c)));
        result.largest = std::max(result.largest, largest);
        differing += largest > options.step + 1e-6 * std::min(1.0, options.step) ? 1 : 0;
        ++seen;
    }
    if (seen > 0) result.fraction = static_cast<double>(differing) / static_cast<double>(seen);
    return result;
}

void check_shapes(const assets::Image& a, const assets::Image& b, const CompareOptions& options) {
    HACHURE_ASSERT(same_size(a, b), "pictures of one size are compared");
    HACHURE_ASSERT(!options.mask || same_size(a, *options.mask), "a mask has its pictures' size");
}

} // namespace

bool all_finite(const assets::Image& image) {
    if (image.type == assets::PixelType::u8) return true;
    const float* values = image.f32();
    return std::all_of(values, values + pixel_count(image) * static_cast<std::size_t>(image.channels),
                       [](float value) { return std::isfinite(value); });
}

PictureDifference compare_pictures(const assets::Image& a, const assets::Image& picture,
                                   const CompareOptions& options) {
    check_shapes(a, picture, options);
    HACHURE_ASSERT(a.channels >= 3 && picture.channels >= 3, "colours are compared");
    PictureDifference result;
    result.finite = all_finite(a) && all_finite(picture);
    if (!result.finite) return result;
    const assets::Image b = options.mask ? filled_from(a, picture, *options.mask) : picture;
    const Steps steps = steps_between(a, b, 3, 255.0, options);
    result.max_difference = steps.largest;
    result.differing_fraction = steps.fraction;
    const std::vector<float> map = flip_error(a, without_rounding(a, b));
    std::vector<double> errors;
    for (std::size_t i = 0; i < map.size(); ++i)
        if (is_seen(options.mask, i)) errors.push_back(static_cast<double>(map[i]));
    result.flip_max = percentile(errors, 1.0);
    result.flip_p99 = percentile(errors, 0.99);
    result.line_distance = line_distance(a, b);
    return result;
}

BufferDifference compare_buffers(const assets::Image& a, const assets::Image& b, const CompareOptions& options) {
    check_shapes(a, b, options);
    HACHURE_ASSERT(a.channels == b.channels, "buffers of one shape are compared");
    BufferDifference result;
    result.finite = all_finite(a) && all_finite(b);
    if (!result.finite) return result;
    const Steps steps = steps_between(a, b, a.channels, 1.0, options);
    result.max_difference = steps.largest;
    result.differing_fraction = steps.fraction;
    return result;
}

} // namespace hachure::picture
