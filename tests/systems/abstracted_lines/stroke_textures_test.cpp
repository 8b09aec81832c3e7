#include <hachure/runtime/error.h>
#include <hachure/systems/abstracted_lines/stroke_frame.h>
#include <hachure/systems/abstracted_lines/stroke_textures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace hachure {
namespace {

TEST(StrokeTextures, AlphaOrDarknessIsInk) {
    assets::Image grey = assets::make_image(2, 1, 3, assets::PixelType::u8);
    for (int c = 0; c < 3; ++c) grey.u8()[3 + c] = 255;
    EXPECT_EQ(ink_of(grey, "a.png").coverage, (std::vector{1.0f, 0.0f}));
    assets::Image alpha = assets::make_image(2, 1, 4, assets::PixelType::f32);
    alpha.f32()[3] = 0.25f;
    alpha.f32()[7] = 2.0f;
    EXPECT_EQ(ink_of(alpha, "a.exr").coverage, (std::vector{0.25f, 1.0f}));
    alpha.f32()[7] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(ink_of(alpha, "a.exr")), Error);
}

TEST(StrokeTextures, DryInkIsMostlyInkWithGaps) {
    const StrokeInk ink = dry_ink();
    ASSERT_EQ(ink.coverage.size(), static_cast<std::size_t>(ink.width * ink.height));
    EXPECT_GT(ink.mean(), 0.5f);
    EXPECT_LT(ink.mean(), 0.95f);
    EXPECT_LT(std::ranges::min(ink.coverage), 0.2f);
    EXPECT_GT(std::ranges::max(ink.coverage), 0.99f);
    EXPECT_EQ(ink.coverage, dry_ink().coverage);
}

/// Zooming by a factor scales the texture by it, and never jumps: where one octave takes over from the next, the one
/// that is seen is the same.
TEST(StrokeTextures, OctavesFollowZoomWithoutAJump) {
    const auto seen = [](float scale) { // the length that has the weight, and the weight of the other
        const TextureOctaves octaves = texture_octaves(96.0f, scale);
        return octaves.blend < 0.5f ? std::pair(octaves.length, octaves.blend)
                                    : std::pair(0.5f * octaves.length, 1.0f - octaves.blend);
    };
    for (float scale = 3.0f; scale < 60.0f; scale *= 1.01f) {
        const auto [length, other] = seen(scale);
        EXPECT_GE(length, 0.70f * 96.0f);
        EXPECT_LE(length, 1.42f * 96.0f);
        const float octave = std::log2(scale), part = octave - std::floor(octave);
        if (part < 0.24f || part > 0.76f) {
            EXPECT_FLOAT_EQ(other, 0.0f);
        }
        const auto [next, next_other] = seen(scale * 1.005f);
        if (other < 0.4f && next_other < 0.4f) {
            EXPECT_NEAR(next / length, 1.005f, 1e-3f) << scale;
        }
        EXPECT_NEAR(next_other, other, 0.05f);
    }
}

} // namespace
} // namespace hachure
