#include <hachure/runtime/picture/line_distance.h>

#include <gtest/gtest.h>

#include <random>

namespace hachure::test {
namespace {

TEST(DistanceTransform, EqualsTheSearchOverAllPixels) {
    std::mt19937 random(3);
    for (const int one_in : {2, 30, 400}) {
        constexpr int w = 37, h = 23;
        std::vector<bool> pixels(w * h);
        for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = random() % static_cast<unsigned>(one_in) == 0;
        pixels[5] = true;
        const std::vector<double> distances = picture::squared_distances(pixels, w, h);
        for (int i = 0; i < w * h; ++i) {
            int nearest = w * w + h * h;
            for (int j = 0; j < w * h; ++j) {
                const int dx = i % w - j % w, dy = i / w - j / w;
                if (pixels[static_cast<std::size_t>(j)]) nearest = std::min(nearest, dx * dx + dy * dy);
            }
            ASSERT_EQ(distances[static_cast<std::size_t>(i)], nearest) << "pixel " << i;
        }
    }
}

} // namespace
} // namespace hachure::test
