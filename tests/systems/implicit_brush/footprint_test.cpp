#include <hachure/systems/implicit_brush/footprint.h>
#include <hachure/tests/support/convolution_reference.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace hachure {
namespace {

constexpr std::array drawn_tips = {BrushTip::disk, BrushTip::soft_disk, BrushTip::line, BrushTip::bristle,
                                   BrushTip::splatter};

/// So opacities of parts add up to at most 1.
TEST(Footprint, HairsAndDropsLieApartWithinTheUnitCircle) {
    for (std::size_t i = 0; i < bristle_hairs.size(); ++i) {
        const glm::vec4& hair = bristle_hairs[i];
        EXPECT_LE(std::hypot(std::abs(hair.x) + hair.z, std::abs(hair.y) + hair.w), 1.0f) << i;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(std::abs(hair.y - bristle_hairs[j].y), hair.w + bristle_hairs[j].w);
    }
    for (std::size_t i = 0; i < splatter_drops.size(); ++i) {
        const glm::vec3& drop = splatter_drops[i];
        EXPECT_LE(std::hypot(drop.x, drop.y) + drop.z, 1.0f) << i;
        for (std::size_t j = 0; j < i; ++j) {
            const glm::vec3& other = splatter_drops[j];
            EXPECT_GE(std::hypot(drop.x - other.x, drop.y - other.y), drop.z + other.z) << i << " " << j;
        }
    }
}

/// The white point is right: `mass` is the integral of what is drawn.
TEST(Footprint, MassIsTheIntegral) {
    for (const BrushTip tip : drawn_tips)
        for (const float aspect : {1.0f, 0.5f})
            for (const double radius : {0.6, 1.0, 4.0, 16.0}) {
                const Footprint footprint{.tip = tip, .aspect = aspect};
                const test::FootprintReference reference(footprint, radius, 0.4, nullptr);
                const double far = footprint.reach(radius), step = std::min(0.1, radius / 40.0);
                double sum = 0.0;
                for (double y = -far; y <= far; y += step)
                    for (double x = -far; x <= far; x += step) sum += step * step * reference.at(x, y)[3];
                EXPECT_NEAR(sum / footprint.mass(radius), 1.0, 5e-3)
                    << static_cast<int>(tip) << " aspect " << aspect << " radius " << radius;
            }
}

TEST(Footprint, ThereIsNoInkBeyondItsReach) {
    for (const BrushTip tip : drawn_tips)
        for (const float aspect : {1.0f, 0.3f})
            for (const double radius : {0.3, 1.0, 2.5, 10.0, 32.0}) {
                const Footprint footprint{.tip = tip, .aspect = aspect};
                const test::FootprintReference reference(footprint, radius, 1.1, nullptr);
                const double far = footprint.reach(radius);
                EXPECT_LE(far, 1.2 * radius + 4.3) << static_cast<int>(tip); // work grows with its square
                for (double angle = 0.0; angle < 6.3; angle += 0.02)
                    for (const double beyond : {1e-6, 0.3, 1.0})
                        EXPECT_EQ(reference.at((far + beyond) * std::cos(angle), (far + beyond) * std::sin(angle))[3],
                                  0.0)
                            << static_cast<int>(tip) << " radius " << radius;
            }
}

TEST(Footprint, OpacityIsWithinItsRange) {
    for (const BrushTip tip : drawn_tips)
        for (const double radius : {0.5, 1.0, 3.0, 20.0}) {
            const test::FootprintReference reference({.tip = tip}, radius, 0.0, nullptr);
            double most = 0.0;
            for (double y = -radius; y <= radius; y += radius / 50.0)
                for (double x = -radius; x <= radius; x += radius / 50.0) most = std::max(most, reference.at(x, y)[3]);
            EXPECT_LE(most, 1.0 + 1e-9) << static_cast<int>(tip) << " " << radius;
            if (radius > 10.0) {
                EXPECT_GT(most, 0.9) << static_cast<int>(tip);
            }
        }
}

} // namespace
} // namespace hachure
