#include <hachure/runtime/assert.h>
#include <hachure/systems/metal/stripe_ramp.h>

#include <glm/vec4.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace hachure {
namespace {

constexpr std::uint64_t purpose = 0x6d6574616c; // "metal": other uses of the same seed draw other numbers

/// The finaliser of SplitMix64: every bit of `x` moves every bit of the result.
constexpr std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

void shift_all(std::vector<double>& values, double by) {
    for (double& value : values) value += by;
}

} // namespace

double stripe_intensity(const StripeSet& set, std::uint32_t index) {
    const double low = std::min(set.low, set.high), high = std::max(set.low, set.high);
    const std::uint64_t bits = mix(mix(mix(set.seed) ^ purpose) ^ index);
    return low + (high - low) * static_cast<double>(bits >> 11) * 0x1p-53;
}

StripeRamp make_stripe_ramp(const StripeSet& set) {
    HACHURE_ASSERT(set.count >= 2, "a set has two stripes or more");
    const std::size_t period = set.mirrored ? 2 * std::size_t{set.count} : set.count;
    std::vector<double> c(period), first(period), second(period);
    for (std::uint32_t i = 0; i < set.count; ++i) {
        c[i] = stripe_intensity(set, i);
        if (set.mirrored) c[period - 1 - i] = c[i];
    }
    const double count = static_cast<double>(period);
    StripeRamp ramp;
    ramp.mean = sum_of(c) / count;
    shift_all(c, -ramp.mean);
    const auto slope = [&](std::size_t i) { return c[(i + 1) % period] - c[i]; };
    // Over a piece the function and its antiderivatives are polynomials: their integrals are exact.
    for (std::size_t i = 0; i + 1 < period; ++i) first[i + 1] = first[i] + c[i] + slope(i) / 2;
    double mean = 0.0;
    for (std::size_t i = 0; i < period; ++i) mean += (first[i] + c[i] / 2 + slope(i) / 6) / count;
    shift_all(first, -mean);
    for (std::size_t i = 0; i + 1 < period; ++i) second[i + 1] = second[i] + first[i] + c[i] / 2 + slope(i) / 6;
    mean = 0.0;
    for (std::size_t i = 0; i < period; ++i) mean += (second[i] + first[i] / 2 + c[i] / 6 + slope(i) / 24) / count;
    shift_all(second, -mean);
    ramp.knots.reserve(period);
    for (std::size_t i = 0; i < period; ++i) ramp.knots.emplace_back(c[i], slope(i), first[i], second[i]);
    return ramp;
}

} // namespace hachure
