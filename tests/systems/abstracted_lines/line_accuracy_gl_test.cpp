// Lines of known place and width, and what the shaders make of them. HACHURE_ALL_LINE_ANGLES=1 takes all 64 angles, and
// more widths and contrasts.

#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/line_sweep.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace hachure {
namespace {

using test::LineScore;
using test::LineSweep;

bool thorough() { return std::getenv("HACHURE_ALL_LINE_ANGLES") != nullptr; }
int angles() { return thorough() ? 64 : 12; }

std::vector<double> widths() {
    if (thorough()) return {2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0, 20.0, 24.0};
    return {2.0, 3.0, 4.0, 7.0, 12.0, 24.0};
}

void expect_accurate(const LineScore& score, const LineSweep& sweep) {
    const auto where = [&] {
        return ::testing::Message() << "width " << sweep.width << " contrast " << sweep.contrast << " noise "
                                    << sweep.noise << " beta " << sweep.beta << (sweep.bright ? " bright" : " dark");
    };
    EXPECT_LE(score.rms(), 0.02 + 0.5 * sweep.noise / sweep.contrast) << where();
    EXPECT_GE(score.recall(), 0.995) << where();
    EXPECT_GE(score.precision(), 0.995) << where();
    EXPECT_NEAR(score.band(), 1.0, 0.05) << where();
    EXPECT_EQ(score.not_finite(), 0u) << where();
}

using LineAccuracyTest = test::GlTest;

TEST_P(LineAccuracyTest, BarsOfTheLinesWidthAreFoundWhereTheyAre) {
    RenderContext render(context());
    for (const double width : widths())
        for (const double contrast : {1.0, 0.03})
            for (const bool bright : {false, true}) {
                const LineSweep sweep{.width = width, .contrast = contrast, .bright = bright, .angles = angles()};
                expect_accurate(sweep.score(render, test::profile::Bar{0.5 * width}), sweep);
            }
}

TEST_P(LineAccuracyTest, SoDoTheyWithOtherParts) {
    RenderContext render(context());
    for (const float beta : {0.1f, 0.3f})
        for (const double width : {3.0, 8.0, 24.0}) {
            const LineSweep sweep{.width = width, .beta = beta, .angles = angles()};
            expect_accurate(sweep.score(render, test::profile::Bar{0.5 * width}), sweep);
        }
}

TEST_P(LineAccuracyTest, RidgesAreFoundWhereTheyAre) {
    RenderContext render(context());
    for (const double width : {3.0, 6.0, 24.0})
        for (const double part : {0.15, 0.3}) {
            const LineSweep sweep{.width = width, .angles = angles()};
            expect_accurate(sweep.score(render, test::profile::Ridge{part * width}), sweep);
        }
}

/// Noise moves a line by .4 noise / contrast pixels, and so takes pixels from its rims: .995 of a line are left while
/// noise <= .01 contrast * width, up to a tenth of the contrast.
TEST_P(LineAccuracyTest, NoiseCostsNoMoreThanItMust) {
    RenderContext render(context());
    for (const double noise : {0.002, 0.02})
        for (const double width : {3.0, 8.0, 24.0})
            for (const double contrast : {1.0, 0.3, 0.1, 0.03}) {
                if (noise > contrast * std::min(0.01 * width, 0.1)) continue;
                const LineSweep sweep{.width = width, .contrast = contrast, .noise = noise, .angles = angles()};
                expect_accurate(sweep.score(render, test::profile::Bar{0.5 * width}), sweep);
            }
}

/// The curvature that thresholds are compared with hardly depends on how a line lies.
TEST_P(LineAccuracyTest, CurvatureIsMuchTheSameAtEveryAngleAndPhase) {
    RenderContext render(context());
    for (const double width : {4.0, 8.0, 24.0}) {
        const LineScore score =
            LineSweep{.width = width, .angles = angles()}.score(render, test::profile::Bar{0.5 * width});
        EXPECT_LE(score.curvature_spread(), 0.15) << width;
        EXPECT_NEAR(0.5 * (score.least_curvature() + score.most_curvature()), 0.19, 0.015) << width;
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(LineAccuracyTest);

} // namespace
} // namespace hachure
