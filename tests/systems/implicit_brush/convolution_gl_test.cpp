// All ways to add stamps up, against each other and against the convolution in double precision.

#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/tests/support/brush_frame.h>
#include <hachure/tests/support/convolution_reference.h>
#include <hachure/tests/support/convolution_run.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using test::ConvolutionRun;
using test::StampImage;

constexpr std::array tips = {BrushTip::disk,    BrushTip::soft_disk, BrushTip::line,
                             BrushTip::bristle, BrushTip::splatter,  BrushTip::bitmap};
constexpr std::array methods = {BrushMethod::splat, BrushMethod::gather, BrushMethod::tiles, BrushMethod::sums};

std::string name_of(BrushMethod method) {
    constexpr std::array names = {"automatic", "splat", "gather", "tiles", "sums"};
    return names[static_cast<std::size_t>(method)];
}

/// A ring with a gap, thicker on one side.
TipImage ring_tip(bool colored) {
    TipImage tip{32, 32, colored, {}};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double u = (x + 0.5) / 16.0 - 1.0, v = (y + 0.5) / 16.0 - 1.0;
            const double away = std::abs(std::hypot(u, v) - 0.6) / (0.25 + 0.1 * u);
            const float opacity = v > 0.7 ? 0.0f : static_cast<float>(std::max(0.0, 1.0 - away * away));
            const float red = colored ? static_cast<float>(0.5 + 0.5 * u) : 1.0f, blue = colored ? 0.2f : 1.0f;
            tip.pixels.insert(tip.pixels.end(), {opacity * red, opacity * 0.5f, opacity * blue, opacity});
        }
    return tip;
}

double most_difference(const std::vector<float>& made, const std::vector<double>& expected) {
    double most = 0.0;
    for (std::size_t i = 0; i < made.size(); ++i) most = std::max(most, std::abs(double(made[i]) - expected[i]));
    return most;
}

void use_tip(ConvolveJob& job, BrushTip tip, float aspect, double radius, double shift, const TipBitmap& bitmap) {
    job.footprint = {.tip = tip, .aspect = aspect, .bitmap_mean = bitmap.mean};
    job.bitmap = tip == BrushTip::bitmap ? &bitmap : nullptr;
    job.radius = job.largest_radius = static_cast<float>(radius);
    job.largest_shift = static_cast<float>(shift);
}

/// Far below what can be seen, 1/255; drivers choose levels of a bitmap less exactly.
double tolerance(BrushTip tip) { return (tip == BrushTip::bitmap ? 0.25 : 0.02) / 255.0; }

using ConvolutionTest = test::GlTest;

/// Stamps along the lines of a real frame, with every form. On one back end: it takes seconds.
TEST_P(ConvolutionTest, MatchesTheReferenceOnAFrame) {
    static bool done = false;
    if (done) GTEST_SKIP() << "done on another back end";
    done = true;
    RenderContext render(context());
    const TipImage image = ring_tip(false);
    const TipBitmap bitmap = make_tip_bitmap(image);
    const test::TipPyramid pyramid(image);
    for (const double radius : {1.0, 3.3, 10.0, 32.0}) {
        const StampImage stamps = test::frame_stamps(context(), 256, radius, {.shift = 1.5, .shrink = 0.5});
        ASSERT_GT(stamps.active(), 500u);
        ConvolutionRun run(render, 256, 256);
        const StampImage stored = run.upload(stamps);
        for (const BrushTip tip : tips) {
            use_tip(run.job, tip, 1.0f, radius, 1.5, bitmap);
            const auto expected = convolution_reference(stored, run.job, &pyramid);
            for (const BrushMethod method : methods) {
                if (method == BrushMethod::gather && radius > 2.0) continue; // seconds: they add as splats do
                if (method == BrushMethod::tiles && radius > 5.0) continue;
                if (method == BrushMethod::sums && tip != BrushTip::disk) continue;
                run.job.method = method;
                run.run();
                EXPECT_LT(most_difference(run.read(), expected), tolerance(tip))
                    << name_of(method) << " tip " << static_cast<int>(tip) << " radius " << radius;
                EXPECT_EQ(run.convolver.counts().method, method);
            }
        }
    }
}

/// Flat, turned, of one colour, at one place: every variant of the shaders.
TEST_P(ConvolutionTest, MatchesTheReferenceWhateverStampsShare) {
    RenderContext render(context());
    const TipImage image = ring_tip(true);
    const TipBitmap bitmap = make_tip_bitmap(image);
    const test::TipPyramid pyramid(image);
    for (const BrushTip tip : tips)
        for (const bool same_place : {false, true})
            for (const bool same_color : {false, true}) {
                ConvolutionRun run(render, 72, 56);
                use_tip(run.job, tip, 0.45f, 5.0, 2.0, bitmap);
                StampImage stamps =
                    run.upload(test::crossed_ring(72, 56, 1.0, 5.0, {.shift = 2.0, .shrink = same_place ? 0.0 : 0.5}));
                const glm::vec4 place{0.3f, -0.7f, 5.0f, 0.6f};
                const glm::vec3 color{0.2f, 0.4f, 0.8f};
                if (same_place) run.job.same_place = place;
                if (same_color) run.job.same_color = color;
                for (StampImage::Stamp& s : stamps.stamps) {
                    if (same_place)
                        std::tie(s.x, s.y, s.radius, s.angle) = std::tie(place.x, place.y, place.z, place.w);
                    if (!same_color) continue;
                    s.red = color.x * s.weight;
                    s.green = color.y * s.weight;
                    s.blue = color.z * s.weight;
                }
                const auto expected = convolution_reference(stamps, run.job, &pyramid, tip == BrushTip::bitmap);
                for (const BrushMethod method : methods) {
                    run.job.method = method;
                    run.run();
                    EXPECT_LT(most_difference(run.read(), expected), tolerance(tip))
                        << name_of(method) << " tip " << static_cast<int>(tip) << same_place << same_color;
                }
            }
}

/// They add in the same order; running sums round each number to a fixed step.
TEST_P(ConvolutionTest, ThePictureDoesNotDependOnTheMethod) {
    RenderContext render(context());
    ConvolutionRun run(render, 90, 70);
    run.job.radius = run.job.largest_radius = 7.0f;
    run.job.largest_shift = 3.0f;
    run.upload(test::crossed_ring(90, 70, 1.2, 7.0, {.shift = 3.0, .shrink = 0.7}));
    run.job.method = BrushMethod::splat;
    run.run();
    const std::vector<float> splats = run.read();
    for (const BrushMethod method : {BrushMethod::gather, BrushMethod::tiles}) {
        run.job.method = method;
        run.run();
        EXPECT_EQ(run.read(), splats) << name_of(method);
    }
    const std::vector<double> expected(splats.begin(), splats.end());
    for (const BrushMethod method : {BrushMethod::sums, BrushMethod::automatic}) {
        run.job.method = method;
        run.run();
        EXPECT_LT(most_difference(run.read(), expected), 0.02 / 255.0) << name_of(method);
    }
}

TEST_P(ConvolutionTest, ShiftsWithItsStamps) {
    RenderContext render(context());
    const StampImage stamps = test::crossed_ring(96, 80, 1.0, 4.0, {.shift = 1.0, .shrink = 0.5});
    StampImage moved(96, 80);
    for (int y = 3; y < 80; ++y)
        for (int x = 5; x < 96; ++x) moved.at(x, y) = stamps.at(x - 5, y - 3);
    for (const BrushMethod method : methods) {
        ConvolutionRun run(render, 96, 80);
        run.job.radius = run.job.largest_radius = 4.0f;
        run.job.largest_shift = 1.0f;
        run.job.method = method;
        const std::vector<float> a = run.ink(stamps), b = run.ink(moved);
        for (int y = 20; y < 60; ++y)
            for (int x = 20; x < 75; ++x)
                for (int c = 0; c < 4; ++c)
                    ASSERT_EQ(b[static_cast<std::size_t>(4 * (y * 96 + x) + c)],
                              a[static_cast<std::size_t>(4 * ((y - 3) * 96 + x - 5) + c)])
                        << name_of(method) << " " << x << " " << y;
    }
}

/// The sum of a stamp over pixels is its footprint's mass, wherever between pixels its middle is: a speck that moves
/// does not flicker.
TEST_P(ConvolutionTest, AStampHasItsMassAtEveryPlaceBetweenPixels) {
    RenderContext render(context());
    const TipBitmap bitmap = make_tip_bitmap(ring_tip(false));
    struct Bound {
        BrushTip tip;
        float aspect;
        double radius, most; ///< relative error
    };
    for (const Bound& bound : {Bound{BrushTip::disk, 1.0f, 0.6, 0.01}, Bound{BrushTip::disk, 1.0f, 1.0, 0.01},
                               Bound{BrushTip::disk, 1.0f, 1.5, 0.005}, Bound{BrushTip::disk, 1.0f, 6.0, 0.002},
                               Bound{BrushTip::disk, 0.4f, 3.0, 0.02}, Bound{BrushTip::soft_disk, 1.0f, 1.0, 0.016},
                               Bound{BrushTip::line, 1.0f, 1.0, 0.08}, Bound{BrushTip::bristle, 1.0f, 1.0, 0.03},
                               Bound{BrushTip::splatter, 1.0f, 1.0, 0.03}, Bound{BrushTip::bitmap, 1.0f, 1.0, 0.06}}) {
        ConvolutionRun run(render, 32, 32, gpu::Format::rgba32f);
        use_tip(run.job, bound.tip, bound.aspect, bound.radius, 1.0, bitmap);
        run.job.contrast = 1.0f; // ink is proportional to the sum
        run.job.method = BrushMethod::splat;
        const double mass = run.job.footprint.mass(bound.radius);
        for (int phase = 0; phase < 12; ++phase) {
            StampImage stamps(32, 32);
            stamps.at(16, 16) = {.x = static_cast<float>(0.37 * phase - std::floor(0.37 * phase)),
                                 .y = static_cast<float>(0.23 * phase - std::floor(0.23 * phase)),
                                 .radius = static_cast<float>(bound.radius),
                                 .angle = 0.2f * static_cast<float>(phase),
                                 .weight = 0.5f};
            const std::vector<float> ink = run.ink(stamps);
            double sum = 0.0;
            for (std::size_t i = 3; i < ink.size(); i += 4) sum += double(ink[i]);
            EXPECT_NEAR(2.0 * sum, 1.0, bound.most) << "tip " << static_cast<int>(bound.tip) << " radius "
                                                    << bound.radius << " phase " << phase << " mass " << mass;
        }
    }
}

TEST_P(ConvolutionTest, NothingIsPaintedWhereNoStampReaches) {
    RenderContext render(context());
    for (const BrushMethod method : methods) {
        ConvolutionRun run(render, 200, 150);
        run.job.radius = run.job.largest_radius = 4.0f;
        run.job.method = method;
        const std::array background{0.2f, 0.3f, 0.4f, 0.5f};
        run.upload(StampImage(200, 150));
        run.run(background);
        std::vector<float> ink = run.read();
        for (std::size_t i = 0; i < ink.size(); ++i) ASSERT_EQ(ink[i], background[i % 4]) << name_of(method);
        EXPECT_EQ(run.convolver.counts().tiles, 0u);

        StampImage speck(200, 150);
        speck.at(8, 8) = {.radius = 4.0f, .weight = 1.0f};
        run.upload(speck);
        run.run(background);
        ink = run.read();
        EXPECT_EQ(run.convolver.counts().stamps, 1u);
        EXPECT_EQ(run.convolver.counts().tiles, 1u) << "of 130: others cost nothing";
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 200; ++x) {
                const float alpha = ink[static_cast<std::size_t>(4 * (y * 200 + x) + 3)];
                if (std::hypot(x - 8, y - 8) > 5.5) {
                    ASSERT_EQ(alpha, 0.5f) << name_of(method) << " " << x << " " << y;
                } else if (std::hypot(x - 8, y - 8) < 4.0) {
                    ASSERT_GT(alpha, 0.5f) << name_of(method) << " " << x << " " << y;
                }
            }
    }
}

/// Stamps that reach over the picture's borders.
TEST_P(ConvolutionTest, BordersCutStamps) {
    RenderContext render(context());
    ConvolutionRun run(render, 40, 30);
    run.job.radius = run.job.largest_radius = 12.0f;
    run.job.largest_shift = 4.0f;
    StampImage stamps(40, 30);
    for (const auto& [x, y] : {std::pair{0, 15}, {39, 3}, {20, 0}, {2, 29}, {37, 28}})
        stamps.at(x, y) = {.x = 1.5f, .y = -3.25f, .radius = 12.0f, .red = 0.25f, .weight = 0.5f};
    const StampImage stored = run.upload(stamps);
    const std::vector<double> expected = convolution_reference(stored, run.job);
    for (const BrushMethod method : methods) {
        run.job.method = method;
        run.run();
        EXPECT_LT(most_difference(run.read(), expected), 0.02 / 255.0) << name_of(method);
    }
}

TEST_P(ConvolutionTest, WhatIsNoNumberStampsNothing) {
    RenderContext render(context());
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const BrushMethod method : methods) {
        ConvolutionRun run(render, 48, 48, gpu::Format::rgba32f);
        run.job.radius = run.job.largest_radius = 3.0f;
        run.job.method = method;
        StampImage stamps(48, 48);
        stamps.at(24, 24) = {.radius = 3.0f, .weight = 1.0f};
        const std::vector<float> expected = run.ink(stamps);
        stamps.at(20, 24) = {.radius = nan, .weight = 1.0f};
        stamps.at(21, 24) = {.x = nan, .radius = 3.0f, .weight = 1.0f};
        stamps.at(22, 24) = {.radius = 3.0f, .weight = nan};
        stamps.at(26, 24) = {.y = infinity, .radius = 3.0f, .weight = 1.0f};
        stamps.at(27, 24) = {.radius = 0.0f, .weight = 1.0f};
        stamps.at(28, 24) = {.radius = 3.0f, .weight = -1.0f};
        EXPECT_EQ(run.ink(stamps), expected) << name_of(method);
    }
}

/// Other pixels' stamps are not looked at, whatever they hold.
TEST_P(ConvolutionTest, OnlyStampsOfTheGivenPixelsCount) {
    RenderContext render(context());
    const StampImage stamps = test::crossed_ring(100, 90, 1.2, 5.0, {.shrink = 0.3});
    const gpu::Rect part{37, 21, 30, 41};
    StampImage inside(100, 90);
    for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) inside.at(x, y) = stamps.at(x, y);
    for (const BrushMethod method : methods) {
        ConvolutionRun run(render, 100, 90);
        run.job.radius = run.job.largest_radius = 5.0f;
        run.job.method = method;
        const std::vector<float> expected = run.ink(inside);
        run.job.stamps = part;
        EXPECT_EQ(run.ink(stamps), expected) << name_of(method);
    }
}

TEST_P(ConvolutionTest, InkLiesOverWhatIsThere) {
    RenderContext render(context());
    for (const BrushMethod method : methods) {
        ConvolutionRun run(render, 64, 64);
        run.job.radius = run.job.largest_radius = 4.0f;
        run.job.method = method;
        const StampImage stamps = test::crossed_ring(64, 64, 1.0, 4.0);
        const std::vector<float> alone = run.ink(stamps);
        const std::array below{0.3f, 0.2f, 0.1f, 0.4f};
        run.run(below);
        const std::vector<float> over = run.read();
        for (std::size_t i = 0; i < over.size(); ++i)
            ASSERT_NEAR(over[i], alone[i] + below[i % 4] * (1.0f - alone[i | 3]), 1e-6f) << name_of(method);
    }
}

/// Tones do not depend on what else is in the picture (section 4.1 with a white point that is fixed).
TEST_P(ConvolutionTest, ADarkPlaceLeavesOthersAsTheyAre) {
    RenderContext render(context());
    ConvolutionRun run(render, 128, 48);
    run.job.radius = run.job.largest_radius = 3.0f;
    StampImage stamps(128, 48);
    for (int x = 10; x < 40; ++x) stamps.at(x, 24) = {.radius = 3.0f, .weight = 0.4f};
    const std::vector<float> before = run.ink(stamps);
    for (int y = 10; y < 40; ++y)
        for (int x = 80; x < 110; ++x) stamps.at(x, y) = {.radius = 3.0f, .weight = 1.0f};
    const std::vector<float> after = run.ink(stamps);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 50; ++x) {
            const auto i = static_cast<std::size_t>(4 * (y * 128 + x) + 3);
            ASSERT_EQ(after[i], before[i]);
        }
    EXPECT_NEAR(after[static_cast<std::size_t>(4 * (24 * 128 + 95) + 3)], 1.0f, 0.002f) << "all pixels stamp: opaque";
}

/// What size follows, tone does not: a line is as dark where its stamps are half as large.
TEST_P(ConvolutionTest, ALineIsAsDarkWhereItIsThinner) {
    RenderContext render(context());
    ConvolutionRun run(render, 64, 64);
    run.job.radius = run.job.largest_radius = 8.0f;
    std::array<float, 2> darkness{};
    for (const float part : {1.0f, 0.5f}) {
        StampImage stamps =
            test::stamps_along(64, 64, [](double x, double) { return x - 32.5; }, 0.8, 8.0 * double(part), {});
        darkness[part < 1.0f] = run.ink(stamps)[static_cast<std::size_t>(4 * (32 * 64 + 32) + 3)];
    }
    EXPECT_NEAR(darkness[1], darkness[0], 0.01f);
    EXPECT_GT(darkness[0], 0.3f);
}

TEST_P(ConvolutionTest, CanvasTakesPaintWhereItsNoiseIsHigh) {
    RenderContext render(context());
    ConvolutionRun run(render, 64, 64);
    run.job.radius = run.job.largest_radius = 4.0f;
    const StampImage stamps = test::crossed_ring(64, 64, 1.0, 4.0);
    const std::vector<float> smooth = run.ink(stamps);
    const std::uint32_t noise = render.backend->create_texture({64, 64, gpu::Format::rgba16f}, "noise");
    run.job.canvas = {.texture = noise, .channel = {0.0f, 1.0f, 0.0f, 0.0f}, .amount = 0.5f};
    for (const BrushMethod method : methods) {
        run.job.method = method;
        render.backend->texture(noise).clear(std::array{1.0f, -1.0f, 1.0f, 1.0f});
        const std::vector<float> spared = run.ink(stamps);
        for (std::size_t i = 0; i < smooth.size(); ++i) ASSERT_NEAR(spared[i], smooth[i], 1e-5f);
        render.backend->texture(noise).clear(std::array{0.0f, 1.0f, 0.0f, 0.0f});
        const std::vector<float> rough = run.ink(stamps);
        const float p = run.job.contrast;
        for (std::size_t i = 3; i < smooth.size(); i += 4) {
            if (smooth[i] <= 0.0f || smooth[i] >= 1.0f) continue;
            const float sum = smooth[i] / (p - (p - 1.0f) * smooth[i]), held = 0.5f * sum; // of the white point
            ASSERT_NEAR(rough[i], p * held / ((p - 1.0f) * held + 1.0f), 1e-4f) << name_of(method);
        }
    }
    render.backend->destroy_texture(noise);
}

/// Why sums are of 32 bits: a dense line of large stamps in half floats.
TEST_P(ConvolutionTest, HalfFloatsAreNotEnoughForSums) {
    RenderContext render(context());
    ConvolutionRun run(render, 96, 96);
    run.job.radius = run.job.largest_radius = 10.0f;
    run.job.method = BrushMethod::splat;
    const StampImage stored = run.upload(test::crossed_ring(96, 96, 2.0, 10.0, {.shrink = 0.3}));
    const std::vector<double> expected = convolution_reference(stored, run.job);
    run.run();
    EXPECT_LT(most_difference(run.read(), expected), 0.02 / 255.0);
    run.job.sums = gpu::Format::rgba16f;
    run.run();
    const double error = most_difference(run.read(), expected);
    EXPECT_GT(error, 0.3 / 255.0);
    EXPECT_LT(error, 0.02);
}

/// The choice is the cheapest by the prices, of what the GPU counted; sparse stamps are not gathered.
TEST_P(ConvolutionTest, AutomaticIsTheCheapestMethod) {
    RenderContext render(context());
    for (const double radius : {1.0, 12.0})
        for (const bool one_color : {false, true}) {
            ConvolutionRun run(render, 128, 96);
            run.job.radius = run.job.largest_radius = static_cast<float>(radius);
            if (one_color) run.job.same_color = glm::vec3(0.0f);
            run.upload(test::crossed_ring(128, 96, 1.0, radius));
            run.run();
            const ConvolutionCounts counts = run.convolver.counts();
            const ConvolutionPrices prices = context_cost(render).prices(run.job, 128, 96);
            for (const BrushMethod method : methods)
                EXPECT_LE(prices.of(counts.method, counts), 1.001 * prices.of(method, counts)) << name_of(method);
            if (radius > 10.0) {
                EXPECT_NE(counts.method, BrushMethod::gather);
            }
        }
}

TEST_P(ConvolutionTest, CostsCanBeMeasured) {
    RenderContext render(context());
    const ConvolutionCost cost = measured_cost(render), given;
    for (const auto& [made, known] : {std::pair{cost.splat_pixel, given.splat_pixel},
                                      {cost.edge, given.edge},
                                      {cost.gather_look, given.gather_look},
                                      {cost.marked_look, given.marked_look}}) {
        EXPECT_GT(made, 0.001 * known);
        EXPECT_LT(made, 1000.0 * known);
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(ConvolutionTest);

} // namespace
} // namespace hachure
