#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "../support/picture_compare.h"

namespace hachure::test {
namespace {

constexpr int width = 160, height = 120;

assets::Image filled(std::array<std::uint8_t, 3> color) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    for (int i = 0; i < width * height; ++i) std::ranges::copy(color, image.u8() + 3 * i);
    return image;
}

void set(assets::Image& image, int x, int y, std::uint8_t value) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    std::fill_n(image.u8() + 3 * (y * width + x), 3, value);
}

/// Two lines, 2 px wide, over a ramp.
assets::Image drawing(int shift, bool second_line) {
    assets::Image image = filled({});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) set(image, x, y, static_cast<std::uint8_t>(150 + x / 2));
    for (int t = 10; t < 60; ++t)
        for (int w = 0; w < 2; ++w) {
            set(image, 20 + t + shift, 30 + w + t / 2, 0);
            if (second_line) set(image, 110 + w + shift, 20 + t, 0);
        }
    return image;
}

TEST(PictureCompare, APictureIsLikeItself) {
    const assets::Image image = drawing(0, true);
    const PictureDifference d = compare_pictures(image, image);
    EXPECT_EQ(d.max_difference, 0.0);
    EXPECT_EQ(d.flip_max, 0.0);
    EXPECT_EQ(d.line_distance, 0.0);
    EXPECT_TRUE(same_driver_gate(image, image));
}

TEST(PictureCompare, CatchesALostLine) {
    const assets::Image whole = drawing(0, true), lost = drawing(0, false);
    EXPECT_FALSE(same_driver_gate(whole, lost));
    EXPECT_GT(line_distance(whole, lost), 20.0);
    EXPECT_EQ(line_distance(whole, lost), line_distance(lost, whole));
    EXPECT_GT(compare_pictures(whole, lost).flip_max, 0.5);
}

TEST(PictureCompare, CatchesAShiftOfThreePixelsByDistance) {
    const double distance = line_distance(drawing(0, true), drawing(3, true));
    EXPECT_GT(distance, 2.0);
    EXPECT_LE(distance, 3.0);
    EXPECT_FALSE(same_driver_gate(drawing(0, true), drawing(3, true)));
}

TEST(PictureCompare, CatchesTwoTurnedPixelsInAThousand) {
    const assets::Image image = drawing(0, true);
    assets::Image turned = image;
    for (int i = 0; i < width * height; i += 500) turned.u8()[3 * i] ^= 0x20;
    EXPECT_FALSE(same_driver_gate(image, turned));
}

TEST(PictureCompare, LetsNoiseOfOneStepPass) {
    const assets::Image image = drawing(0, true);
    assets::Image noisy = image;
    std::mt19937 random(7);
    for (int i = 0; i < width * height * 3; ++i) {
        const int value = noisy.u8()[i] + static_cast<int>(random() % 3) - 1;
        noisy.u8()[i] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
    }
    EXPECT_GT(compare_pictures(image, noisy).max_difference, 0.0);
    EXPECT_TRUE(same_driver_gate(image, noisy));
}

TEST(PictureCompare, CatchesNaNAndOtherSizes) {
    assets::Image a = assets::make_image(8, 8, 3, assets::PixelType::f32);
    assets::Image b = a;
    EXPECT_TRUE(same_driver_gate(a, b));
    b.f32()[40] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(same_driver_gate(a, b));
    EXPECT_FALSE(same_driver_gate(b, b));
    EXPECT_FALSE(same_driver_gate(a, assets::make_image(8, 9, 3, assets::PixelType::f32)));
}

TEST(PictureCompare, AWhollyLostDrawingIsInfinitelyFar) {
    EXPECT_TRUE(std::isinf(line_distance(drawing(0, true), filled({255, 255, 255}))));
    EXPECT_EQ(line_distance(filled({255, 255, 255}), filled({200, 255, 255})), 0.0);
}

TEST(Flip, GreenAgainstBlueIsTheLargestError) {
    for (const float error : flip_error(filled({0, 255, 0}), filled({0, 0, 255}))) ASSERT_NEAR(error, 1.0f, 1e-5f);
}

/// Between flat pictures no edge amplifies: the error is the remapped HyAB difference of their colours. White against
/// black differs by 100 in L*; the paper's constants then give .95 + .05 (100^.7 - .4 c) / (.6 c), c = 203.3^.7.
TEST(Flip, WhiteAgainstBlackFollowsTheFormula) {
    const double c = std::pow(203.3, 0.7);
    const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * c) / (0.6 * c);
    for (const float error : flip_error(filled({0, 0, 0}), filled({255, 255, 255}))) ASSERT_NEAR(error, expected, 1e-3);
}

TEST(Flip, IsSymmetricAndGrowsWithContrast) {
    const assets::Image base = filled({200, 200, 200});
    float before = 0.0f;
    for (const int value : {195, 180, 140, 60}) {
        assets::Image image = base;
        for (int y = 40; y < 80; ++y) set(image, 80, y, static_cast<std::uint8_t>(value));
        const std::vector<float> error = flip_error(base, image);
        EXPECT_EQ(error, flip_error(image, base));
        const float largest = *std::ranges::max_element(error);
        EXPECT_GT(largest, before);
        before = largest;
    }
}

TEST(DistanceTransform, EqualsTheSearchOverAllPixels) {
    std::mt19937 random(3);
    for (const int one_in : {2, 30, 400}) {
        constexpr int w = 37, h = 23;
        std::vector<bool> pixels(w * h);
        for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = random() % static_cast<unsigned>(one_in) == 0;
        pixels[5] = true;
        const std::vector<double> distances = squared_distances(pixels, w, h);
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
