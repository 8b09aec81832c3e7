#include <hachure/systems/metal/stripe_ramp.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace hachure {
namespace {

double value(const StripeRamp& ramp, double x) {
    const double whole = std::floor(x), t = x - whole;
    const auto period = static_cast<double>(ramp.knots.size());
    const auto& knot = ramp.knots[static_cast<std::size_t>(whole - period * std::floor(whole / period))];
    return double(knot.x) + t * double(knot.y);
}

/// An antiderivative as the shader evaluates it: order 1 is C, order 2 is D.
double antiderivative(const StripeRamp& ramp, double x, int order) {
    const double whole = std::floor(x), t = x - whole;
    const auto period = static_cast<double>(ramp.knots.size());
    const auto& k = ramp.knots[static_cast<std::size_t>(whole - period * std::floor(whole / period))];
    if (order == 1) return double(k.z) + t * (double(k.x) + t * double(k.y) / 2);
    return double(k.w) + t * (double(k.z) + t * (double(k.x) / 2 + t * double(k.y) / 6));
}

std::vector<StripeSet> sets() {
    return {{.seed = 1, .count = 20},
            {.seed = 7, .count = 2, .low = 0.2f, .high = 0.9f},
            {.seed = 3, .count = 33, .mirrored = true},
            {.seed = 4294967295u, .count = 256, .low = 0.7f, .high = 0.1f, .mirrored = true}};
}

TEST(StripeRampTest, IntensitiesAreWithinTheRangeAndSpreadOverIt) {
    const StripeSet set{.seed = 5, .low = 0.25f, .high = 0.75f};
    double least = 1.0, most = 0.0, sum = 0.0;
    constexpr int count = 4000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double c = stripe_intensity(set, i);
        least = std::min(least, c);
        most = std::max(most, c);
        sum += c;
    }
    EXPECT_GE(least, 0.25);
    EXPECT_LT(most, 0.75);
    EXPECT_LT(least, 0.252);
    EXPECT_GT(most, 0.748);
    // The mean of so many uniform numbers: three standard deviations are 3 * .5 / sqrt(12 * 4000).
    EXPECT_NEAR(sum / count, 0.5, 3.0 * 0.5 / std::sqrt(12.0 * count));
}

TEST(StripeRampTest, AFunctionOfSeedAndIndexAlone) {
    const StripeSet a{.seed = 1}, b{.seed = 2};
    std::set<double> seen;
    for (std::uint32_t i = 0; i < 20; ++i) {
        EXPECT_EQ(stripe_intensity(a, i), stripe_intensity({.seed = 1, .count = 100, .mirrored = true}, i));
        EXPECT_NE(stripe_intensity(a, i), stripe_intensity(b, i));
        seen.insert(stripe_intensity(a, i));
    }
    EXPECT_EQ(seen.size(), 20u);
    // Kept from version to version: pictures with a seed stay what they are.
    EXPECT_NEAR(stripe_intensity(a, 0), 0.10552584602307258, 1e-12);
    EXPECT_NEAR(stripe_intensity(a, 1), 0.3889104468394731, 1e-12);
}

TEST(StripeRampTest, KnotsAreTheIntensitiesAboutTheirMean) {
    for (const StripeSet& set : sets()) {
        const StripeRamp ramp = make_stripe_ramp(set);
        ASSERT_EQ(ramp.knots.size(), set.mirrored ? 2 * set.count : set.count);
        double sum = 0.0;
        for (std::uint32_t i = 0; i < set.count; ++i) {
            EXPECT_NEAR(double(ramp.knots[i].x) + ramp.mean, stripe_intensity(set, i), 1e-6);
            const std::size_t image = set.mirrored ? 2 * set.count - 1 - i : i;
            EXPECT_EQ(ramp.knots[image].x, ramp.knots[i].x);
            sum += stripe_intensity(set, i);
        }
        EXPECT_NEAR(ramp.mean, sum / set.count, 1e-12);
    }
}

/// Both antiderivatives grow by the integral of what they are antiderivatives of, by Simpson's rule, which is exact
/// within a piece; they are periodic, and their means are 0.
TEST(StripeRampTest, AntiderivativesAreThoseOfTheRamp) {
    for (const StripeSet& set : sets()) {
        const StripeRamp ramp = make_stripe_ramp(set);
        const auto period = static_cast<double>(ramp.knots.size());
        constexpr double h = 1.0 / 16;
        double worst_first = 0.0, worst_second = 0.0, sum_first = 0.0, sum_second = 0.0;
        for (double x = -3.0; x < period + 3.0; x += h) {
            const double end = x + h * (1.0 - 1e-9); // still on the same piece
            const auto simpson = [&](const auto& f) { return h * (f(x) + 4.0 * f(x + h / 2) + f(end)) / 6.0; };
            const double c = simpson([&](double at) { return value(ramp, at); });
            const double first = simpson([&](double at) { return antiderivative(ramp, at, 1); });
            const double second = simpson([&](double at) { return antiderivative(ramp, at, 2); });
            worst_first =
                std::max(worst_first, std::abs(antiderivative(ramp, x + h, 1) - antiderivative(ramp, x, 1) - c));
            worst_second =
                std::max(worst_second, std::abs(antiderivative(ramp, x + h, 2) - antiderivative(ramp, x, 2) - first));
            if (x < 0.0 || x >= period) continue;
            sum_first += first;
            sum_second += second;
        }
        EXPECT_LT(worst_first, 2e-6);
        EXPECT_LT(worst_second, 2e-5); // up to 40 in size, in floats
        EXPECT_NEAR(sum_first / period, 0.0, 1e-6);
        EXPECT_NEAR(sum_second / period, 0.0, 1e-4);
    }
}

} // namespace
} // namespace hachure
