#include <hachure/runtime/picture/flicker.h>
#include <hachure/runtime/picture/pixels.h>
#include <hachure/runtime/picture/popping.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace hachure::test {
namespace {

constexpr int width = 80, height = 60;

assets::Image white() {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    std::fill_n(image.u8(), 3 * width * height, std::uint8_t{255});
    return image;
}

/// A black line through (x, 30) in that direction (radians), anti-aliased: darkness is what it covers of a pixel along
/// x.
void add_line(assets::Image& image, double x, double line_width, double angle, double ink = 1.0) {
    for (int py = 10; py < 50; ++py)
        for (int px = 0; px < width; ++px) {
            const double middle = x + std::tan(angle) * (py + 0.5 - 30.0), half = 0.5 * line_width / std::cos(angle);
            const double covered = std::min(px + 1.0, middle + half) - std::max<double>(px, middle - half);
            const std::size_t pixel = static_cast<std::size_t>(py * width + px);
            for (int c = 0; c < 3 && covered > 0.0; ++c)
                picture::set_channel(image, pixel, c, picture::channel(image, pixel, c) - ink * covered);
        }
}

picture::Flicker flicker_of(int frames, const std::function<assets::Image(int)>& frame, int reach = 2) {
    picture::FlickerMeter meter(reach);
    for (int i = 0; i < frames; ++i) meter.add(frame(i));
    return meter.result();
}

assets::Image line_at(double x, double line_width = 1.0, double angle = 0.2, double ink = 1.0) {
    assets::Image image = white();
    add_line(image, x, line_width, angle, ink);
    return image;
}

TEST(Flicker, IsZeroForAStillPicture) {
    const picture::Flicker still = flicker_of(8, [](int) { return line_at(30.3); });
    EXPECT_EQ(still.mean, 0.0);
    EXPECT_EQ(still.largest, 0.0);
}

TEST(Flicker, IsNearZeroForLinesThatMoveSteadily) {
    for (const double speed : {0.1, 0.37, 0.5, 1.0, 1.7, 2.0})
        for (const double line_width : {1.0, 1.5, 3.0})
            for (const double angle : {0.0, 0.2, 0.7}) {
                const picture::Flicker moving =
                    flicker_of(12, [&](int i) { return line_at(25.0 + speed * i, line_width, angle); });
                EXPECT_LT(moving.p99, 0.01) << speed << " px a frame, " << line_width << " px wide, angle " << angle;
                EXPECT_LT(moving.largest, 0.04)
                    << speed << " px a frame, " << line_width << " px wide, angle " << angle;
            }
}

TEST(Flicker, IsNearZeroForAFadeAndForALineThatAppearsOnce) {
    EXPECT_LT(flicker_of(12, [](int i) { return line_at(30, 2, 0.2, i / 11.0); }).largest, 0.01);
    EXPECT_LT(flicker_of(12, [](int i) { return i < 6 ? white() : line_at(30); }).largest, 0.01);
}

TEST(Flicker, IsLargeForALineThatBlinks) {
    const picture::Flicker thin = flicker_of(9, [](int i) { return i % 2 ? line_at(30.5, 1, 0) : white(); });
    EXPECT_GT(thin.mean, 0.1);
    EXPECT_NEAR(thin.largest, 0.375, 0.01);
    EXPECT_GT(flicker_of(9, [](int i) { return i % 2 ? line_at(30.5, 3, 0) : white(); }).p99, 0.8);
}

/// Also while another line moves beside it, and when it is one frame in eight.
TEST(Flicker, FindsABlinkingLineAmongOthers) {
    const auto frame = [](int i) {
        assets::Image image = line_at(10.0 + i);
        if (i % 8 == 4) add_line(image, 60, 2, 0.1);
        return image;
    };
    EXPECT_GT(flicker_of(24, frame).p99, 0.04);
}

TEST(Flicker, FindsJitterBeyondItsReach) {
    const auto jitter = [](double step) { return [step](int i) { return line_at(30 + (i % 2 ? step : 0.0), 1, 0); }; };
    EXPECT_GT(flicker_of(9, jitter(6.0)).p99, 0.2);
    EXPECT_LT(flicker_of(9, jitter(6.0), 8).p99, 0.01) << "what is reached counts as motion";
}

TEST(Flicker, NoiseOfOneStepIsNearlyNothing) {
    std::mt19937 random(5);
    const auto noisy = [&](int) {
        assets::Image image = line_at(30);
        for (int i = 0; i < 3 * width * height; ++i)
            image.u8()[i] = static_cast<std::uint8_t>(std::clamp(image.u8()[i] + int(random() % 3) - 1, 0, 255));
        return image;
    };
    EXPECT_LT(flicker_of(9, noisy).p99, 0.003);
}

TEST(Popping, MeasuresTheLargestChange) {
    picture::PoppingMeter meter;
    assets::Image image = white();
    EXPECT_FALSE(meter.add(image).has_value());
    EXPECT_EQ(meter.add(image)->largest, 0.0);
    image.u8()[777] = 215;
    const picture::Popping one = *meter.add(image);
    EXPECT_NEAR(one.largest, 40.0, 1e-9);
    EXPECT_EQ(one.p999, 0.0) << "one pixel of many";
    EXPECT_NEAR(meter.add(line_at(30, 4, 0))->p999, 255.0, 1e-9);
}

/// readings: halve the step and the largest change halves, too, unless something pops.
TEST(Popping, HalvesWithTheStepOfAFadeAndStaysForAPop) {
    const auto largest = [](int frames, bool pops) {
        picture::PoppingMeter meter;
        double result = 0.0;
        for (int i = 0; i <= frames; ++i) {
            const double progress = static_cast<double>(i) / frames;
            const auto change = meter.add(line_at(30, 2, 0, pops ? (progress < 0.5 ? 0.0 : 0.6) : progress));
            if (change) result = std::max(result, change->largest);
        }
        return result;
    };
    EXPECT_NEAR(largest(16, false) / largest(8, false), 0.5, 0.03);
    EXPECT_NEAR(largest(16, true) / largest(8, true), 1.0, 0.03);
}

TEST(Popping, MotionWithinReachIsNone) {
    const auto largest = [](int reach, double x0, double x1) {
        picture::PoppingMeter meter(reach);
        meter.add(line_at(x0));
        return meter.add(line_at(x1))->largest;
    };
    EXPECT_GT(largest(0, 30.0, 31.0), 150.0);
    EXPECT_LT(largest(2, 30.0, 31.0), 6.0);
    EXPECT_GT(largest(2, 30.0, 40.0), 60.0);
    picture::PoppingMeter meter(2);
    meter.add(white());
    EXPECT_GT(meter.add(line_at(30))->largest, 60.0) << "a line that was not there moved from nowhere";
}

} // namespace
} // namespace hachure::test
