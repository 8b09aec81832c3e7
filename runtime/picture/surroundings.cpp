#include <hachure/runtime/assert.h>
#include <hachure/runtime/picture/pixels.h>
#include <hachure/runtime/picture/surroundings.h>

#include <algorithm>
#include <cmath>

namespace hachure::picture {
namespace {

using Samples = std::vector<float>;

/// Calls `combine(k)` for the indices of the pixels around each one, first along rows, then along columns; what leaves
/// the picture is its edge.
template <class Combine> Samples separable(const Samples& in, int width, int height, int radius, Combine combine) {
    Samples rows(in.size()), out(in.size());
    std::vector<float> window(static_cast<std::size_t>(2 * radius + 1));
    const auto index = [width](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            for (int k = -radius; k <= radius; ++k)
                window[static_cast<std::size_t>(k + radius)] = in[index(std::clamp(x + k, 0, width - 1), y)];
            rows[index(x, y)] = combine(window);
        }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            for (int k = -radius; k <= radius; ++k)
                window[static_cast<std::size_t>(k + radius)] = rows[index(x, std::clamp(y + k, 0, height - 1))];
            out[index(x, y)] = combine(window);
        }
    return out;
}

} // namespace

Surroundings::Surroundings(const assets::Image& picture, int reach) {
    HACHURE_ASSERT(picture.channels >= 3 && reach >= 0, "colours have surroundings");
    for (std::size_t c = 0; c < 3; ++c) {
        Samples plane(pixel_count(picture));
        for (std::size_t i = 0; i < plane.size(); ++i)
            plane[i] = static_cast<float>(channel(picture, i, static_cast<int>(c)));
        plane = separable(plane, picture.width, picture.height, 2, [](const std::vector<float>& w) {
            return (w[0] + w[4] + 4.0f * (w[1] + w[3]) + 6.0f * w[2]) / 16.0f;
        });
        low_[c] = separable(plane, picture.width, picture.height, reach,
                            [](const auto& w) { return *std::ranges::min_element(w); });
        high_[c] = separable(plane, picture.width, picture.height, reach,
                             [](const auto& w) { return *std::ranges::max_element(w); });
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const float margin = 0.25f * (high_[c][i] - low_[c][i]);
            low_[c][i] -= margin;
            high_[c][i] += margin;
        }
        values_[c] = std::move(plane);
    }
}

} // namespace hachure::picture
