// The generators of lines and the search in double precision against closed forms: what the shaders are held to must
// itself be right. The last tests say what the method reaches on ideal blurs.

#include <hachure/tests/support/line_images.h>
#include <hachure/tests/support/line_score.h>
#include <hachure/tests/support/tone_ridge_reference.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace hachure::test {
namespace {

using std::numbers::pi;

double sum(const Tones& tones) { return std::accumulate(tones.values.begin(), tones.values.end(), 0.0); }

/// A bar of exactly the width that is looked for, at many angles and phases.
LineScore score_bars(const RidgeSearch& search, double contrast, double noise, int angles) {
    LineScore score(search.width);
    const int size = 2 * static_cast<int>(4.0 * search.fitted_width() + 10.0);
    for (int k = 0; k < angles; ++k) {
        const auto line = TrueLine::through_middle(size, size, pi * k / angles, spread_phase(k));
        Tones image = draw_line(size, size, line, profile::Bar{0.5 * search.width}, 1.0, -contrast);
        add_noise(image, noise, static_cast<std::uint64_t>(k));
        const Tones tones = blurred(image, search.deviation());
        const BilinearTone tone{tones};
        LineFit fit(tone, search);
        const int rim = static_cast<int>(3.0 * search.fitted_width());
        for (int y = rim; y < size - rim; ++y)
            for (int x = rim; x < size - rim; ++x) {
                const double d = line.distance(pixel_center(x, y));
                if (std::abs(d) > 1.7 * search.fitted_width()) continue;
                const FoundLine found = search_line(fit, search, pixel_center(x, y));
                const bool drawn = found.drawn(search.width) && found.curvature > 0.0;
                score.add(d, drawn ? 1.0 : 0.0, -glm::dot(found.offset, line.normal));
                if (std::abs(d) < 0.5) score.add_curvature(found.curvature);
            }
    }
    return score;
}

TEST(LineImages, MeansOfPixelsAreThoseOfManyPoints) {
    const profile::Bar bar{1.3, 0.25};
    for (const double angle : {0.0, 1e-7, 0.3, pi / 4, 1.2, pi / 2, 2.5}) {
        const auto line = TrueLine::through_middle(12, 12, angle, 0.37);
        const Tones exact = draw_line(12, 12, line, bar, 0.9, -0.5);
        const Tones points = draw_points(12, 12, 100, [&](glm::dvec2 p) {
            const double u = line.distance(p);
            return 0.9 - 0.5 * (u < -bar.h ? 0.0 : u < bar.h ? 1.0 : bar.beyond);
        });
        for (std::size_t i = 0; i < exact.values.size(); ++i)
            ASSERT_NEAR(exact.values[i], points.values[i], 0.006) << angle << " " << i;
    }
}

TEST(LineImages, MeansOfARidgeAreThoseOfManyPoints) {
    for (const double angle : {0.0, 0.3, 2.5}) {
        const auto line = TrueLine::through_middle(12, 12, angle, 0.37);
        const Tones exact = draw_line(12, 12, line, profile::Ridge{0.8}, 0.0, 1.0);
        const Tones points = draw_points(12, 12, 64, [&](glm::dvec2 p) {
            const double u = line.distance(p) / 0.8;
            return std::exp(-0.5 * u * u);
        });
        for (std::size_t i = 0; i < exact.values.size(); ++i) ASSERT_NEAR(exact.values[i], points.values[i], 1e-4);
    }
}

TEST(LineImages, ARingCoversItsArea) {
    const Tones ring = draw_ring(40, 40, {20.3, 19.6}, 11.7, 1.5, 0.0, 1.0);
    EXPECT_NEAR(sum(ring), 2.0 * pi * 11.7 * 3.0, 1e-9);
    EXPECT_NEAR(ring.at(20 + 11, 19), 1.0, 1e-12);
    EXPECT_NEAR(ring.at(20, 19), 0.0, 1e-12);
}

TEST(LineImages, NoiseIsNormalAndTheSameAgain) {
    Tones noise(300, 300, 0.0);
    add_noise(noise, 0.02, 7);
    double squares = 0.0, fourths = 0.0;
    for (const double v : noise.values) squares += v * v, fourths += v * v * v * v;
    const auto n = static_cast<double>(noise.values.size());
    EXPECT_NEAR(sum(noise) / n, 0.0, 3e-4);
    EXPECT_NEAR(std::sqrt(squares / n), 0.02, 3e-4);
    EXPECT_NEAR(fourths * n / (squares * squares), 3.0, 0.1);
    Tones again(300, 300, 0.0);
    add_noise(again, 0.02, 7);
    EXPECT_EQ(noise.values, again.values);
}

TEST(ToneRidgeReference, FitsQuadraticsExactly) {
    const auto tone = [](glm::dvec2 p) {
        return 0.7 * p.x * p.x - 0.4 * p.x * p.y + 0.1 * p.y * p.y + p.x - 2 * p.y + 3;
    };
    for (const int side : {3, 5})
        for (const double weight : {1.0, 4.0}) {
            RidgeSearch search;
            search.side = side, search.middle_weight = weight;
            const Quadratic q = QuadraticFit(search).fit(tone, {0.0, 0.0});
            const std::array<double, 6> expected = {0.7, -0.2, 0.1, 1.0, -2.0, 3.0};
            for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(q.a[k], expected[k], 1e-11);
        }
}

TEST(ToneRidgeReference, TheStrongerEigenvalueIsChosenWithItsDirection) {
    for (int k = 0; k < 32; ++k) {
        const double angle = 0.1 + pi * k / 32;
        const glm::dvec2 u(std::cos(angle), std::sin(angle)), v(-u.y, u.x);
        for (const double strong : {2.0, -2.0}) {
            const double weak = 0.5;
            const auto m = [&](int i, int j) { return strong * u[i] * u[j] + weak * v[i] * v[j]; };
            glm::dvec2 direction;
            EXPECT_NEAR(strongest_eigenvalue({{m(0, 0), m(0, 1), m(1, 1), 0, 0, 0}}, direction), strong, 1e-12);
            EXPECT_NEAR(std::abs(glm::dot(direction, u)), 1.0, 1e-12);
        }
    }
}

TEST(ToneRidgeReference, ABlurredBarIsTheClosedForm) {
    const double s = 4.0, h = 3.0;
    const auto line = TrueLine::through_middle(80, 80, 0.0, 0.3);
    const Tones tones = blurred(draw_line(80, 80, line, profile::Bar{h}, 1.0, -0.6), s);
    const double wide = std::sqrt(s * s + 1.0 / 12.0); // a pixel is a blur, too
    const auto step = [&](double u) { return 0.5 * std::erfc(-u / (wide * std::numbers::sqrt2)); };
    for (int x = 20; x < 60; ++x) {
        const double u = line.distance(pixel_center(x, 40));
        // Pixels do not keep all of a sharp edge: the sum of their squares depends on the phase.
        EXPECT_NEAR(tones.at(x, 40), 1.0 - 0.6 * (step(u + h) - step(u - h)), 5e-4);
    }
}

TEST(ToneRidgeReference, ABlurredRidgeIsTheClosedForm) {
    const double s = 4.0, r = 2.0, wide = std::sqrt(s * s + r * r + 1.0 / 12.0);
    const auto line = TrueLine::through_middle(80, 80, 0.4, 0.3);
    const Tones tones = blurred(draw_line(80, 80, line, profile::Ridge{r}, 0.2, 0.7), s);
    for (int x = 25; x < 55; ++x) {
        const double u = line.distance(pixel_center(x, 40)) / wide;
        EXPECT_NEAR(tones.at(x, 40), 0.2 + 0.7 * r / wide * std::exp(-0.5 * u * u), 1e-5);
    }
}

TEST(ToneRidgeReference, AnAsymmetricBarIsOffByTheKnownBias) {
    const double beyond = 0.3;
    RidgeSearch search;
    search.width = 8.0, search.polish = 6;
    const auto line = TrueLine::through_middle(120, 120, 0.0, 0.3);
    const Tones tones = blurred(draw_line(120, 120, line, profile::Bar{4.0, beyond}, 1.0, -1.0), search.deviation());
    const BilinearTone tone{tones};
    LineFit fit(tone, search);
    const FoundLine found = search_line(fit, search, pixel_center(60, 60));
    ASSERT_TRUE(found.settled);
    // Steger 1998, with what the fit smooths: s^2 + w^2 / 12.
    const double s2 = 16.0 + 64.0 / 12.0, bias = -s2 / 8.0 * std::log(1.0 - beyond);
    EXPECT_NEAR(line.distance(pixel_center(60, 60) + found.offset), bias, 0.1 * bias);
}

TEST(ToneRidgeReference, ReachesItsBoundsOnBars) {
    for (const double width : {2.0, 3.0, 5.0, 12.0}) {
        RidgeSearch search;
        search.width = width, search.guard = 0.0025, search.polish = 2;
        const LineScore score = score_bars(search, 1.0, 0.0, 16);
        EXPECT_LE(score.rms(), 0.02) << width;
        EXPECT_GE(score.recall(), 0.995) << width;
        EXPECT_GE(score.precision(), 0.995) << width;
        EXPECT_EQ(score.not_finite(), 0u);
    }
}

/// Noise of the first derivative over curvature, both at the scale of blur and fit together, s^2 + w^2 / 12: for a bar
/// of width w that is .42 noise / contrast pixels, whatever w.
TEST(ToneRidgeReference, NoiseMovesALineByTwoFifthsOfItsShareOfTheContrast) {
    for (const double width : {4.0, 8.0}) {
        RidgeSearch search;
        search.width = width, search.guard = 0.002, search.polish = 2;
        const LineScore score = score_bars(search, 0.2, 0.01, 48);
        EXPECT_NEAR(score.rms(), 0.4 * 0.01 / 0.2, 0.004) << width;
    }
}

} // namespace
} // namespace hachure::test
