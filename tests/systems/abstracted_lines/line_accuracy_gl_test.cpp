// Lines of known place and width, and what the shaders make of them. HACHURE_ALL_LINE_ANGLES=1 takes all 64 angles, and
// more widths and contrasts.

#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/line_finding.h>
#include <hachure/tests/support/line_score.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace hachure {
namespace {

using test::LineFinding;
using test::LineScore;
using test::PixelLine;
using test::Tones;
using test::TrueLine;

bool thorough() { return std::getenv("HACHURE_ALL_LINE_ANGLES") != nullptr; }

/// A sweep: lines of one width, at many angles and phases.
struct Sweep {
    double width = 4.0;
    double contrast = 1.0;
    double noise = 0.0;
    float beta = 0.2f;
    bool bright = false;
    ToneImage quality = {};

    [[nodiscard]] int size() const { return 2 * static_cast<int>(4.0 * std::max(width, 3.0) + 10.0); }

    /// Draws `profile` at every angle and scores what is found.
    template <class Profile> LineScore score(RenderContext& render, const Profile& profile) const {
        AbstractedLines lines = test::plain_lines(width, contrast);
        lines.beta = beta;
        LineFinding finding(render, lines, quality, size(), size());
        LineScore score(width);
        const int angles = thorough() ? 64 : 12;
        for (int k = 0; k < angles; ++k) {
            const auto line = TrueLine::through_middle(size(), size(), std::numbers::pi * k / angles,
                                                       test::spread_phase(k + static_cast<int>(8.0 * width)));
            const double background = bright ? 0.5 - 0.5 * contrast : 0.5 + 0.5 * contrast;
            Tones tones = test::draw_line(size(), size(), line, profile, background, bright ? contrast : -contrast);
            test::add_noise(tones, noise, static_cast<std::uint64_t>(k));
            add(score, line, finding.find(tones));
        }
        return score;
    }

private:
    /// Pixels so near that they could be taken for the line's, and so far from the border that it does not matter.
    void add(LineScore& score, const TrueLine& line, const std::vector<PixelLine>& found) const {
        const double searched = std::max(width, 3.0);
        const int rim = static_cast<int>(3.0 * searched);
        for (int y = rim; y < size() - rim; ++y)
            for (int x = rim; x < size() - rim; ++x) {
                const double d = line.distance(test::pixel_center(x, y));
                if (std::abs(d) > 1.7 * searched) continue;
                const PixelLine& pixel = found[static_cast<std::size_t>(y * size() + x)];
                score.add(d, bright ? pixel.highlight : pixel.dark, -glm::dot(pixel.offset, line.normal));
                if (std::abs(d) < 0.5) score.add_curvature(std::abs(pixel.curvature));
            }
    }
};

std::vector<double> widths() {
    if (thorough()) return {2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0, 20.0, 24.0};
    return {2.0, 3.0, 4.0, 7.0, 12.0, 24.0};
}

void expect_accurate(const LineScore& score, const Sweep& sweep) {
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
                const Sweep sweep{.width = width, .contrast = contrast, .bright = bright};
                expect_accurate(sweep.score(render, test::profile::Bar{0.5 * width}), sweep);
            }
}

TEST_P(LineAccuracyTest, SoDoTheyWithOtherParts) {
    RenderContext render(context());
    for (const float beta : {0.1f, 0.3f})
        for (const double width : {3.0, 8.0, 24.0}) {
            const Sweep sweep{.width = width, .beta = beta};
            expect_accurate(sweep.score(render, test::profile::Bar{0.5 * width}), sweep);
        }
}

TEST_P(LineAccuracyTest, RidgesAreFoundWhereTheyAre) {
    RenderContext render(context());
    for (const double width : {3.0, 6.0, 24.0})
        for (const double part : {0.15, 0.3}) {
            const Sweep sweep{.width = width};
            expect_accurate(sweep.score(render, test::profile::Ridge{part * width}), sweep);
        }
}

/// Noise moves a line by .4 noise / contrast pixels, so of the pixels of its rims 2 * .32 noise / (contrast width) / 2
/// change sides: .995 of a line are left while noise <= .0125 contrast * width.
TEST_P(LineAccuracyTest, NoiseCostsNoMoreThanItMust) {
    RenderContext render(context());
    for (const double noise : {0.002, 0.02})
        for (const double width : {3.0, 8.0, 24.0})
            for (const double contrast : {1.0, 0.3, 0.1, 0.03}) {
                if (noise > 0.0125 * contrast * width) continue;
                const Sweep sweep{.width = width, .contrast = contrast, .noise = noise};
                expect_accurate(sweep.score(render, test::profile::Bar{0.5 * width}), sweep);
            }
}

/// The curvature that thresholds are compared with hardly depends on how a line lies.
TEST_P(LineAccuracyTest, CurvatureIsMuchTheSameAtEveryAngleAndPhase) {
    RenderContext render(context());
    for (const double width : {4.0, 8.0, 24.0}) {
        const LineScore score = Sweep{.width = width}.score(render, test::profile::Bar{0.5 * width});
        EXPECT_LE(score.curvature_spread(), 0.15) << width;
        EXPECT_NEAR(0.5 * (score.least_curvature() + score.most_curvature()), 0.19, 0.015) << width;
    }
}

HACHURE_INSTANTIATE_GL_TESTS(LineAccuracyTest);

} // namespace
} // namespace hachure
