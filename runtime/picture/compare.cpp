#include <hachure/runtime/assert.h>
#include <hachure/runtime/picture/compare.h>
#include <hachure/runtime/picture/flip.h>
#include <hachure/runtime/picture/line_distance.h>
#include <hachure/runtime/picture/pixels.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hachure::picture {

bool all_finite(const assets::Image& image) {
    if (image.type == assets::PixelType::u8) return true;
    const float* values = image.f32();
    return std::all_of(values, values + pixel_count(image) * static_cast<std::size_t>(image.channels),
                       [](float value) { return std::isfinite(value); });
}

PictureDifference compare_pictures(const assets::Image& a, const assets::Image& b) {
    HACHURE_ASSERT(same_size(a, b), "pictures of one size are compared");
    HACHURE_ASSERT(a.channels >= 3 && b.channels >= 3, "colours are compared");
    PictureDifference result;
    result.finite = all_finite(a) && all_finite(b);
    if (!result.finite) return result;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < pixel_count(a); ++i) {
        double largest = 0.0;
        for (int c = 0; c < 3; ++c) largest = std::max(largest, 255.0 * std::abs(channel(a, i, c) - channel(b, i, c)));
        result.max_difference = std::max(result.max_difference, largest);
        differing += largest > same_driver_step + 1e-6 ? 1 : 0;
    }
    result.differing_fraction = static_cast<double>(differing) / static_cast<double>(pixel_count(a));
    std::vector<float> errors = flip_error(a, b);
    result.flip_max = *std::ranges::max_element(errors);
    const auto p99 = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) * 99 / 100);
    std::ranges::nth_element(errors, p99);
    result.flip_p99 = *p99;
    result.line_distance = line_distance(a, b);
    return result;
}

} // namespace hachure::picture
