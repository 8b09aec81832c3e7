#include <hachure/runtime/picture/flip.h>
#include <hachure/tests/runtime/picture/drawing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hachure::test {
namespace {

TEST(Flip, GreenAgainstBlueIsTheLargestError) {
    for (const float error : picture::flip_error(filled({0, 255, 0}), filled({0, 0, 255})))
        ASSERT_NEAR(error, 1.0f, 1e-5f);
}

/// Between flat pictures no edge amplifies: the error is the remapped HyAB difference of their colours. White against
/// black differs by 100 in L*; the paper's constants then give .95 + .05 (100^.7 - .4 c) / (.6 c), c = 203.3^.7.
TEST(Flip, WhiteAgainstBlackFollowsTheFormula) {
    const double c = std::pow(203.3, 0.7);
    const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * c) / (0.6 * c);
    for (const float error : picture::flip_error(filled({0, 0, 0}), filled({255, 255, 255})))
        ASSERT_NEAR(error, expected, 1e-3);
}

TEST(Flip, IsSymmetricAndGrowsWithContrast) {
    const assets::Image base = filled({200, 200, 200});
    float before = 0.0f;
    for (const int value : {195, 180, 140, 60}) {
        assets::Image image = base;
        for (int y = 40; y < 80; ++y) set(image, 80, y, static_cast<std::uint8_t>(value));
        const std::vector<float> error = picture::flip_error(base, image);
        EXPECT_EQ(error, picture::flip_error(image, base));
        const float largest = *std::ranges::max_element(error);
        EXPECT_GT(largest, before);
        before = largest;
    }
}

} // namespace
} // namespace hachure::test
