// A jump of exposure in a video: light is halved from one frame to the next. Tones are coded as sRGB codes light, so
// that theirs is not a plain factor.

#include <hachure/tests/support/feature_finding.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/wave_picture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace hachure::test {
namespace {

constexpr int exposed_size = 128;

double decoded(double tone) { return tone <= 0.04045 ? tone / 12.92 : std::pow((tone + 0.055) / 1.055, 2.4); }
double encoded(double light) { return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

std::vector<PixelProfile> luminance_edges(RenderContext& render, const std::function<double(double)>& exposed) {
    const WavePicture picture;
    Tones tones(exposed_size, exposed_size);
    for (int y = 0; y < exposed_size; ++y)
        for (int x = 0; x < exposed_size; ++x)
            tones.at(x, y) = exposed(std::clamp(picture.tone(pixel_center(x, y)), 0.0, 1.0));
    FeatureFinding finding(render, {.feature = BrushFeature::luminance_edges, .diffusion = 4, .fits = 3}, exposed_size,
                           exposed_size);
    finding.find(tones);
    return finding.profiles();
}

/// How lines before and after the jump differ, of pixels beside one.
struct LineChange {
    double mean = 0.0, most = 0.0;         ///< px that lines move
    double weakest = 1e9, strongest = 0.0; ///< height after / before
    int pixels = 0, lost = 0;

    LineChange(const std::vector<PixelProfile>& before, const std::vector<PixelProfile>& after, double least) {
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i].height < least || glm::length(before[i].offset) > 1.0) continue;
            ++pixels;
            if (!after[i].found()) {
                ++lost;
                continue;
            }
            const double moved = glm::distance(before[i].offset, after[i].offset),
                         ratio = after[i].height / before[i].height;
            mean += moved;
            most = std::max(most, moved);
            weakest = std::min(weakest, ratio), strongest = std::max(strongest, ratio);
        }
        mean /= std::max(pixels - lost, 1);
    }
};

using BrushExposureTest = GlTest;

/// Tones times a half: slopes times a half, and nothing moves.
TEST_P(BrushExposureTest, HalfTheToneIsHalfTheHeightAtTheSamePlace) {
    RenderContext render(context());
    const LineChange change(luminance_edges(render, [](double t) { return t; }),
                            luminance_edges(render, [](double t) { return 0.5 * t; }), 0.05);
    EXPECT_GT(change.pixels, 500);
    EXPECT_EQ(change.lost, 0);
    EXPECT_LE(change.most, 0.01);
    EXPECT_NEAR(change.weakest, 0.5, 0.005);
    EXPECT_NEAR(change.strongest, 0.5, 0.005);
}

/// Light times a half: an edge's dark side loses less than its bright one, which moves it, by less than a pixel can
/// show.
TEST_P(BrushExposureTest, HalfTheLightHardlyMovesLines) {
    RenderContext render(context());
    const LineChange change(luminance_edges(render, [](double t) { return t; }),
                            luminance_edges(render, [](double t) { return encoded(0.5 * decoded(t)); }), 0.05);
    EXPECT_GT(change.pixels, 500);
    EXPECT_LE(change.lost, change.pixels / 200);
    EXPECT_LE(change.mean, 0.05);
    EXPECT_GE(change.weakest, 0.49) << "black is coded linearly";
    EXPECT_LE(change.strongest, 0.85) << "of .73: that of a power of 1/2.4";
    RecordProperty("moved", std::to_string(change.mean) + " px, " + std::to_string(change.most) + " at most; heights " +
                                std::to_string(change.weakest) + " to " + std::to_string(change.strongest));
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushExposureTest);

} // namespace
} // namespace hachure::test
