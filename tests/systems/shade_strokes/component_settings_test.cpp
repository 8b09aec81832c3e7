#include <hachure/systems/shade_strokes/component_settings.h>

#include <gtest/gtest.h>

#include <limits>

namespace hachure::test {
namespace {

TEST(ShadeComponentTest, DefaultsAreThoseOfTheJobs) {
    EXPECT_EQ(shade_settings({}), ShadeSettings{});
    EXPECT_EQ(shade_tone({}), ShadeTone{});
}

TEST(ShadeComponentTest, NumbersThatAreNoneAreMadeSound) {
    ShadeStrokes strokes;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    strokes.amplitude = strokes.min_amplitude = strokes.dead_band = strokes.trueness = strokes.chain_turn = nan;
    strokes.density = -1.0f;
    strokes.no_shade = nan;
    const ShadeSettings settings = shade_settings(strokes);
    EXPECT_GT(settings.amplitude, 0.0f);
    EXPECT_GT(settings.min_amplitude, 0.0f);
    EXPECT_GT(settings.density, 0.0f);
    EXPECT_GT(settings.dead_band, 0.0f);
    EXPECT_GE(settings.trueness, 0.0f);
    EXPECT_GE(settings.chain_turn, 0.0f);
    EXPECT_GE(shade_tone(strokes).no_shade, 0.0f);
}

} // namespace
} // namespace hachure::test
