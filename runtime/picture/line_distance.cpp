#include <hachure/runtime/picture/line_distance.h>
#include <hachure/runtime/picture/pixels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::picture {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Pixels whose channels are all below `limit` (0 to 1).
std::vector<bool> dark_pixels(const assets::Image& image, double limit) {
    std::vector<bool> dark(pixel_count(image));
    for (std::size_t i = 0; i < dark.size(); ++i)
        dark[i] = std::max({channel(image, i, 0), channel(image, i, 1), channel(image, i, 2)}) < limit;
    return dark;
}

double directed_line_distance(const assets::Image& from, const assets::Image& to) {
    const std::vector<bool> strong = line_pixels(from);
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

std::vector<bool> line_pixels(const assets::Image& image) { return dark_pixels(image, 64.0 / 255.0); }

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

} // namespace hachure::picture
