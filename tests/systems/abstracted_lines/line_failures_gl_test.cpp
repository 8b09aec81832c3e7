// Where the method fails or nearly does (readings of Lee 2007): what must not happen there, and what it still reaches.

#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/line_finding.h>
#include <hachure/tests/support/line_score.h>
#include <hachure/tests/support/tone_ridge_reference.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hachure {
namespace {

using test::LineFinding;
using test::PixelLine;
using test::Tones;
using test::TrueLine;

using std::numbers::pi;

class LineFailuresTest : public test::GlTest {
protected:
    /// What is found in a square picture.
    static std::vector<PixelLine> find(RenderContext& render, const AbstractedLines& lines, const Tones& tones,
                                       const ToneImage& quality = {}) {
        return LineFinding(render, lines, quality, tones.width, tones.height).find(tones);
    }

    static bool anything_drawn(const std::vector<PixelLine>& lines) {
        return std::ranges::any_of(lines, [](const PixelLine& p) { return p.dark > 0.0 || p.highlight > 0.0; });
    }
};

Tones ramp(int size, double angle, double from, double slope) {
    const auto line = TrueLine::through_middle(size, size, angle, 0.0);
    return test::draw_points(size, size, 1, [&](glm::dvec2 p) { return from + slope * line.distance(p); });
}

TEST_P(LineFailuresTest, FlatTonesAndRampsHaveNoLines) {
    RenderContext render(context());
    for (const float beta : {0.0f, 0.2f, 1.0f})
        for (const double width : {1.5, 3.0, 4.0, 9.0}) {
            AbstractedLines lines;
            lines.width = static_cast<float>(width), lines.beta = beta;
            LineFinding finding(render, lines, {}, 64, 64);
            for (const double tone : {0.0, 0.37, 1.0}) {
                EXPECT_FALSE(anything_drawn(finding.find(Tones(64, 64, tone)))) << tone;
                EXPECT_TRUE(finding.all_finite());
            }
            for (const double angle : {0.0, 0.4, pi / 4, 2.0}) {
                const std::vector<PixelLine> found = finding.find(ramp(64, angle, 0.5, 0.01));
                EXPECT_TRUE(finding.all_finite()) << angle;
                for (int y = 20; y < 44; ++y) // at the border of the picture a ramp has edges
                    for (int x = 20; x < 44; ++x) {
                        const PixelLine& p = found[static_cast<std::size_t>(y * 64 + x)];
                        ASSERT_EQ(p.dark + p.highlight, 0.0) << angle << " " << x << " " << y;
                    }
            }
        }
}

/// Black and white and nothing between, also beyond what tones can be: much is found, and all of it is numbers.
TEST_P(LineFailuresTest, SaturatedPicturesGiveNumbers) {
    RenderContext render(context());
    for (const double width : {0.5, 2.0, 4.0, 16.0})
        for (const float beta : {0.0f, 0.2f, 1.0f})
            for (const ToneStorage storage : {ToneStorage::rg16, ToneStorage::rg16f, ToneStorage::rg8}) {
                AbstractedLines lines;
                lines.width = static_cast<float>(width), lines.beta = beta;
                LineFinding finding(render, lines, {.quality = ToneQuality::custom, .storage = storage}, 96, 96);
                Tones tones(96, 96);
                for (std::size_t i = 0; i < tones.values.size(); ++i)
                    tones.values[i] = test::normal_noise(3, i / 5) > 0.0 ? 3.0 : -2.0;
                const std::vector<PixelLine> found = finding.find(tones, &tones);
                EXPECT_TRUE(finding.all_finite()) << width << " " << beta;
                EXPECT_TRUE(anything_drawn(found)) << width << " " << beta;
                for (const PixelLine& p : found) {
                    ASSERT_GE(std::min(p.dark, p.highlight), 0.0);
                    ASSERT_LE(std::max(p.dark, p.highlight), 1.0);
                }
            }
}

/// On a flat ground they are the same bit for bit.
TEST_P(LineFailuresTest, MovedByWholePixelsTheyMoveAlong) {
    RenderContext render(context());
    constexpr int size = 160, rim = 50, dx = 7, dy = 3;
    AbstractedLines lines;
    lines.width = 5.0f;
    for (const ToneQuality preset : {ToneQuality::fast, ToneQuality::standard, ToneQuality::accurate}) {
        LineFinding finding(render, lines, {.quality = preset}, size, size);
        Tones tones(size, size), moved = tones;
        for (int y = rim; y < size - rim; ++y)
            for (int x = rim; x < size - rim; ++x)
                tones.at(x, y) = moved.at(x + dx, y - dy) =
                    0.5 + 0.2 * test::normal_noise(5, static_cast<std::uint64_t>(y * size + x / 3));
        const std::vector<PixelLine> a = finding.find(tones), b = finding.find(moved);
        double ink = 0.0;
        for (int y = dy; y < size; ++y)
            for (int x = 0; x < size - dx; ++x) {
                const PixelLine& was = a[static_cast<std::size_t>(y * size + x)];
                const PixelLine& is = b[static_cast<std::size_t>((y - dy) * size + x + dx)];
                ASSERT_EQ(was.offset, is.offset) << x << " " << y;
                ASSERT_EQ(was.curvature, is.curvature) << x << " " << y;
                ASSERT_EQ(was.dark, is.dark) << x << " " << y;
                ASSERT_EQ(was.highlight, is.highlight) << x << " " << y;
                ink += was.dark;
            }
        EXPECT_GT(ink, 100.0);
    }
}

/// Where a picture reaches up to its borders, what moves in at one of them moves roundings; nobody sees that.
TEST_P(LineFailuresTest, WhatMovesInAtTheBorderIsNotSeenElsewhere) {
    RenderContext render(context());
    AbstractedLines lines;
    lines.width = 5.0f;
    LineFinding finding(render, lines, {}, 160, 160);
    Tones tones(160, 160);
    for (std::size_t i = 0; i < tones.values.size(); ++i) tones.values[i] = 0.5 + 0.2 * test::normal_noise(5, i / 3);
    Tones moved = tones;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) moved.at(x, y) = tones.clamped(x - 7, y + 3);
    const std::vector<PixelLine> a = finding.find(tones), b = finding.find(moved);
    for (int y = 40; y < 120; ++y)
        for (int x = 40; x < 120; ++x) {
            const PixelLine& was = a[static_cast<std::size_t>((y + 3) * 160 + x - 7)];
            const PixelLine& is = b[static_cast<std::size_t>(y * 160 + x)];
            ASSERT_NEAR(was.dark, is.dark, 0.25 / 255.0) << x << " " << y;
            ASSERT_NEAR(was.highlight, is.highlight, 0.25 / 255.0) << x << " " << y;
            ASSERT_LE(glm::distance(was.offset, is.offset), 5e-3) << x << " " << y;
        }
}

/// The shaders against the search in double precision, but for pixels so near the rim that they may call it an edge.
TEST_P(LineFailuresTest, TheSearchIsThatOfTheReference) {
    RenderContext render(context());
    for (const double width : {3.0, 6.0, 11.0}) {
        const int size = 2 * static_cast<int>(4.0 * width + 10.0);
        const auto line = TrueLine::through_middle(size, size, 0.7, 0.2);
        const Tones tones = test::draw_line(size, size, line, test::profile::Bar{0.3 * width, 0.4}, 0.9, -0.5);
        const AbstractedLines lines = test::plain_lines(width, 0.5);
        ToneImage quality{.quality = ToneQuality::custom, .storage = ToneStorage::rg32f, .iterations = 8};
        const std::vector<PixelLine> found = find(render, lines, tones, quality);
        const Tones blurred = test::blurred(tones, 0.5 * width, 2.75);
        const test::BilinearTone tone{blurred};
        const test::RidgeSearch search{
            .width = width, .iterations = 5, .polish = 4, .guard = 0.25 * static_cast<double>(lines.dark_low)};
        test::LineFit fit(tone, search);
        int compared = 0;
        const int rim = static_cast<int>(3.0 * width);
        for (int y = rim; y < size - rim; ++y)
            for (int x = rim; x < size - rim; ++x) {
                const test::FoundLine expected = test::search_line(fit, search, test::pixel_center(x, y));
                if (!expected.settled || expected.rim > 0.35 * width || expected.curvature < 0.0) continue;
                const PixelLine& p = found[static_cast<std::size_t>(y * size + x)];
                ++compared;
                ASSERT_NEAR(glm::dot(p.offset - expected.offset, line.normal), 0.0, 0.02 + 0.004 * width)
                    << width << " " << x << " " << y;
                ASSERT_NEAR(p.curvature, expected.curvature, 2e-3) << width << " " << x << " " << y;
            }
        EXPECT_GT(compared, 5 * static_cast<int>(width));
    }
}

/// Dark bars that meet in the middle of a picture.
class Junction {
public:
    void add(double angle, bool whole) { arms_.push_back({angle, whole}); }

    [[nodiscard]] double distance(glm::dvec2 p) const {
        double nearest = 1e9;
        for (const Arm& arm : arms_) {
            const glm::dvec2 along(std::cos(arm.angle), std::sin(arm.angle)), q = p - glm::dvec2(64.3, 63.8);
            const double u = glm::dot(q, along);
            nearest = std::min(nearest, glm::length(q - (arm.whole ? u : std::max(u, 0.0)) * along));
        }
        return nearest;
    }

    /// The part of the pixels of its lines near the middle that are drawn.
    [[nodiscard]] double recall(const std::vector<PixelLine>& found, double width) const {
        double inside = 0.0, drawn = 0.0;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const glm::dvec2 p = test::pixel_center(x, y);
                if (distance(p) > 0.5 * width || glm::distance(p, glm::dvec2(64.3, 63.8)) > 4.0 * width) continue;
                inside += 1.0;
                drawn += found[static_cast<std::size_t>(y * 128 + x)].dark >= 0.5 ? 1.0 : 0.0;
            }
        return drawn / inside;
    }

    [[nodiscard]] Tones draw(double width) const {
        return test::draw_points(128, 128, 8, [&](glm::dvec2 p) { return distance(p) <= 0.5 * width ? 0.0 : 1.0; });
    }

private:
    struct Arm {
        double angle;
        bool whole;
    };
    std::vector<Arm> arms_;
};

TEST_P(LineFailuresTest, LinesThatMeetLoseLittle) {
    RenderContext render(context());
    Junction square, slanted, tee;
    square.add(0.2, true), square.add(0.2 + pi / 2, true);
    slanted.add(0.2, true), slanted.add(0.2 + pi / 4, true);
    tee.add(0.2, true), tee.add(0.2 + pi / 2, false);
    const double width = 6.0;
    const AbstractedLines lines = test::plain_lines(width, 1.0);
    EXPECT_GE(square.recall(find(render, lines, square.draw(width)), width), 0.96);
    EXPECT_GE(slanted.recall(find(render, lines, slanted.draw(width)), width), 0.80);
    EXPECT_GE(tee.recall(find(render, lines, tee.draw(width)), width), 0.93);
}

/// A bar half a pixel wide, steeper than a pixel in ten: a rasteriser that looks at the middles of pixels misses it in
/// long stretches, one with four samples sees it everywhere.
TEST_P(LineFailuresTest, HalfAPixelNeedsFourSamples) {
    RenderContext render(context());
    LineFinding finding(render, test::plain_lines(4.0, 0.1), {}, 96, 96);
    const auto seen = [&](int samples) {
        double drawn = 0.0, all = 0.0;
        for (int k = 0; k < 4; ++k) {
            const auto line = TrueLine::through_middle(96, 96, 0.05, test::spread_phase(k));
            const std::vector<PixelLine> found = finding.find(test::draw_points(
                96, 96, samples, [&](glm::dvec2 p) { return std::abs(line.distance(p)) <= 0.25 ? 0.0 : 1.0; }));
            for (int y = 30; y < 66; ++y)
                for (int x = 30; x < 66; ++x) {
                    if (std::abs(line.distance(test::pixel_center(x, y))) > 1.0) continue;
                    all += 1.0;
                    drawn += found[static_cast<std::size_t>(y * 96 + x)].dark > 0.5 ? 1.0 : 0.0;
                }
        }
        return drawn / all;
    };
    EXPECT_LE(seen(1), 0.75);
    EXPECT_GE(seen(2), 0.99);
}

/// "A bit ratty" (section 1): how far the outline of a drawn circle is from a circle.
TEST_P(LineFailuresTest, TheOutlineOfACircleIsSmooth) {
    RenderContext render(context());
    for (const double width : {2.0, 4.0, 9.0}) {
        const glm::dvec2 center(80.3, 79.6);
        const double radius = 50.0;
        const Tones ring = test::draw_ring(160, 160, center, radius, 0.5 * width, 1.0, -1.0);
        const std::vector<PixelLine> found = find(render, test::plain_lines(width, 1.0), ring);
        Tones opacity(160, 160);
        for (std::size_t i = 0; i < found.size(); ++i) opacity.values[i] = found[i].dark;
        const test::BilinearTone at{opacity};
        for (const double side : {-1.0, 1.0}) {
            double sum = 0.0, squares = 0.0;
            constexpr int rays = 1000;
            for (int k = 0; k < rays; ++k) {
                const double angle = 2.0 * pi * k / rays;
                const glm::dvec2 out(std::cos(angle), std::sin(angle));
                double r = 0.0; // from the ring's middle to where half the opacity is left
                while (r < 2.0 * width && at(center + (radius + side * r) * out) >= 0.5) r += 0.01;
                sum += r, squares += r * r;
            }
            const double mean = sum / rays;
            EXPECT_LE(std::sqrt(squares / rays - mean * mean), 0.15) << width << " " << side;
            // A blurred ring is narrower than it was drawn: s^2 / 2 r.
            const double searched = std::max(width, 3.0), shrunk = searched * searched / 3.0 / (2.0 * radius);
            EXPECT_NEAR(mean, 0.5 * width - side * shrunk, 0.1) << width << " " << side;
        }
    }
}

/// An edge of tones has a dark line on its dark side and a highlight on its bright one, each where the blurred edge
/// bends most: 1.1 to 1.7 deviations of what blur and fit smooth together.
TEST_P(LineFailuresTest, AnEdgeHasALineOnEachSide) {
    RenderContext render(context());
    for (const double width : {4.0, 8.0}) {
        AbstractedLines lines = test::plain_lines(width, 1.0);
        lines.beta = 0.1f;
        const auto edge = TrueLine::through_middle(120, 120, 0.3, 0.2);
        const Tones tones = test::draw_line(120, 120, edge, test::profile::Step{}, 0.2, 0.6);
        const std::vector<PixelLine> found = find(render, lines, tones);
        const double deviation = std::sqrt(0.25 * width * width + width * width / 12.0);
        double dark = 0.0, dark_place = 0.0, bright = 0.0, bright_place = 0.0;
        for (int y = 45; y < 75; ++y)
            for (int x = 30; x < 90; ++x) {
                const PixelLine& p = found[static_cast<std::size_t>(y * 120 + x)];
                const double place = edge.distance(test::pixel_center(x, y) + p.offset);
                dark += p.dark, dark_place += p.dark * place;
                bright += p.highlight, bright_place += p.highlight * place;
            }
        ASSERT_GT(dark, 0.0);
        ASSERT_GT(bright, 0.0);
        EXPECT_NEAR(dark_place / dark / deviation, -1.4, 0.3) << width;
        EXPECT_NEAR(bright_place / bright / deviation, 1.4, 0.3) << width;
    }
}

/// The larger beta, the fewer edges; lines along bars stay (figure 4).
TEST_P(LineFailuresTest, BetaTakesEdgesAwayAndLeavesLines) {
    RenderContext render(context());
    const auto line = TrueLine::through_middle(120, 120, 0.3, 0.2);
    const Tones edge = test::draw_line(120, 120, line, test::profile::Step{}, 0.2, 0.6);
    const Tones bar = test::draw_line(120, 120, line, test::profile::Bar{3.0}, 0.8, -0.6);
    std::vector<double> of_edge, of_bar;
    for (const float beta : {0.0f, 0.1f, 0.2f, 0.3f, 0.5f, 1.0f}) {
        AbstractedLines lines = test::plain_lines(6.0, 0.6);
        lines.beta = beta, lines.dark_low = 0.01f, lines.dark_high = 0.03f;
        LineFinding finding(render, lines, {}, 120, 120);
        const auto ink = [&](const Tones& tones) {
            double sum = 0.0;
            for (const PixelLine& p : finding.find(tones)) sum += p.dark;
            return sum;
        };
        of_edge.push_back(ink(edge)), of_bar.push_back(ink(bar));
    }
    EXPECT_TRUE(std::ranges::is_sorted(of_edge, std::greater<>()));
    EXPECT_LE(of_edge[2], 0.95 * of_edge[0]);
    EXPECT_GE(of_edge[2], 0.1 * of_edge[0]);
    EXPECT_LE(of_edge.back(), 0.02 * of_edge[0]);
    for (const double ink : of_bar) EXPECT_NEAR(ink / of_bar[0], 1.0, 0.05);
}

/// Thinner than what pixels can show: the same line, drawn thinner and then fainter, never lost at once.
TEST_P(LineFailuresTest, ThinLinesFade) {
    RenderContext render(context());
    const auto line = TrueLine::through_middle(96, 96, 0.4, 0.3);
    Tones tones = test::draw_line(96, 96, line, test::profile::Bar{1.0}, 1.0, -0.5);
    test::add_noise(tones, 0.01, 1);
    double before = 1e9;
    for (const double width : {3.0, 2.5, 2.0, 1.5, 1.0, 0.7, 0.4, 0.1}) {
        const std::vector<PixelLine> found = find(render, test::plain_lines(width, 0.5), tones);
        double ink = 0.0, squares = 0.0, count = 0.0;
        for (int y = 30; y < 66; ++y)
            for (int x = 30; x < 66; ++x) {
                const PixelLine& p = found[static_cast<std::size_t>(y * 96 + x)];
                ink += p.dark;
                if (p.dark <= 0.0) continue;
                const double error = glm::dot(p.offset, line.normal) + line.distance(test::pixel_center(x, y));
                squares += error * error, count += 1.0;
            }
        const double length = 36.0 / std::cos(0.4);
        EXPECT_NEAR(ink / length, width, 0.1 * width + 0.05) << width;
        EXPECT_LT(ink, before) << width;
        EXPECT_LE(std::sqrt(squares / count), 0.1) << width;
        before = ink;
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(LineFailuresTest);

} // namespace
} // namespace hachure
