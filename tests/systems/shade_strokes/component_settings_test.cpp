#include <hachure/systems/shade_strokes/component_settings.h>

#include <gtest/gtest.h>

#include <limits>

namespace hachure::test {
namespace {

TEST(ShadeComponentTest, DefaultsAreThoseOfTheJobs) {
    EXPECT_EQ(shade_settings({}), ShadeSettings{});
    EXPECT_EQ(shade_tone({}), ShadeTone{});
}

/// Half of the light that counts as full: what was needed at a light of x is needed at a relative light of 2x.
TEST(ShadeComponentTest, FullLightMeasuresTheStrongest) {
    const ShadeStrokes strokes{.full_shade = 0.1f, .no_shade = 0.4f, .full_light = 800.0f};
    EXPECT_EQ(shade_tone(strokes, 400.0f), (ShadeTone{.full_shade = 0.2f, .no_shade = 0.8f}));
    EXPECT_EQ(shade_tone(strokes, 800.0f), (ShadeTone{.full_shade = 0.1f, .no_shade = 0.4f}));
    EXPECT_GT(shade_tone(strokes, 0.0f).full_shade, 1000.0f) << "all is dark";
    EXPECT_EQ(shade_tone({}, 400.0f), ShadeTone{}) << "relative to the strongest, whatever that is";
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
