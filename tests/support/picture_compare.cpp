#include "picture_compare.h"

#include <hachure/runtime/assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t pixel_count(const assets::Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Channel of a pixel on the scale of 0 to 1.
double channel(const assets::Image& image, std::size_t pixel, int c) {
    const std::size_t at = pixel * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c);
    return image.type == assets::PixelType::u8 ? image.u8()[at] / 255.0 : static_cast<double>(image.f32()[at]);
}

bool all_finite(const assets::Image& image) {
    if (image.type == assets::PixelType::u8) return true;
    const float* values = image.f32();
    return std::all_of(values, values + pixel_count(image) * static_cast<std::size_t>(image.channels),
                       [](float value) { return std::isfinite(value); });
}

/// Pixels whose channels are all below `limit` (0 to 1).
std::vector<bool> dark_pixels(const assets::Image& image, double limit) {
    std::vector<bool> dark(pixel_count(image));
    for (std::size_t i = 0; i < dark.size(); ++i)
        dark[i] = std::max({channel(image, i, 0), channel(image, i, 1), channel(image, i, 2)}) < limit;
    return dark;
}

double directed_line_distance(const assets::Image& from, const assets::Image& to) {
    const std::vector<bool> strong = dark_pixels(from, 64.0 / 255.0);
    const std::vector<double> distances = squared_distances(dark_pixels(to, 96.0 / 255.0), to.width, to.height);
    double farthest = 0.0;
    for (std::size_t i = 0; i < strong.size(); ++i)
        if (strong[i]) farthest = std::max(farthest, distances[i]);
    return std::sqrt(farthest);
}

/// The lower envelope of parabolas rooted at (i, values[i * stride]), written back in place.
void transform_line(double* values, int count, std::size_t stride) {
    std::vector<double> heights(static_cast<std::size_t>(count));
    std::vector<int> roots;
    std::vector<double> starts; // where the parabola of roots[k] becomes the lowest
    for (int i = 0; i < count; ++i) heights[static_cast<std::size_t>(i)] = values[static_cast<std::size_t>(i) * stride];
    const auto height = [&](int i) { return heights[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < count; ++i) {
        if (height(i) == infinity) continue;
        double start = -infinity;
        while (!roots.empty()) {
            const int r = roots.back();
            start = (height(i) + double(i) * i - height(r) - double(r) * r) / (2.0 * (i - r));
            if (start > starts.back()) break;
            roots.pop_back();
            starts.pop_back();
        }
        if (roots.empty()) start = -infinity;
        roots.push_back(i);
        starts.push_back(start);
    }
    if (roots.empty()) return;
    std::size_t k = 0;
    for (int i = 0; i < count; ++i) {
        while (k + 1 < roots.size() && starts[k + 1] < i) ++k;
        const double away = i - roots[k];
        values[static_cast<std::size_t>(i) * stride] = away * away + height(roots[k]);
    }
}

} // namespace

std::vector<double> squared_distances(const std::vector<bool>& set, int width, int height) {
    std::vector<double> result(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) result[i] = set[i] ? 0.0 : infinity;
    const auto w = static_cast<std::size_t>(width);
    for (std::size_t x = 0; x < w; ++x) transform_line(result.data() + x, height, w);
    for (int y = 0; y < height; ++y) transform_line(result.data() + static_cast<std::size_t>(y) * w, width, 1);
    return result;
}

double line_distance(const assets::Image& a, const assets::Image& b) {
    return std::max(directed_line_distance(a, b), directed_line_distance(b, a));
}

PictureDifference compare_pictures(const assets::Image& a, const assets::Image& b) {
    HACHURE_ASSERT(a.width == b.width && a.height == b.height, "pictures of one size are compared");
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

::testing::AssertionResult same_driver_gate(const assets::Image& a, const assets::Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels < 3 || b.channels < 3)
        return ::testing::AssertionFailure() << "the pictures differ in size or have no colour";
    const PictureDifference d = compare_pictures(a, b);
    const bool alike = d.finite && d.differing_fraction <= 0.001 && d.flip_p99 <= 0.05 && d.line_distance <= 2.0;
    return (alike ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << "largest difference " << d.max_difference << "/255, " << 100.0 * d.differing_fraction
           << " % of pixels beyond " << same_driver_step << "/255, FLIP p99 " << d.flip_p99 << " max " << d.flip_max
           << ", lines " << d.line_distance << " px apart" << (d.finite ? "" : ", not finite");
}

} // namespace hachure::test
