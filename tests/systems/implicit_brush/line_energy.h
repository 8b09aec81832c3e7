#pragma once

#include <hachure/tests/support/feature_finding.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace hachure::test {

/// What a brush of a deviation of a pixel would paint: its weights, with a peak that follows height from `low` to
/// `high`. A straight line of full weight has 2.5 for each pixel of its length.
inline double line_energy(std::span<const PixelProfile> profiles, double low, double high) {
    double sum = 0.0;
    for (const PixelProfile& p : profiles) {
        const double square = p.offset.x * p.offset.x + p.offset.y * p.offset.y;
        if (p.found()) sum += std::clamp((p.height - low) / (high - low), 0.0, 1.0) * std::exp(-0.5 * square);
    }
    return sum;
}

/// The most that one of these differs from the one before.
inline double largest_step(std::span<const double> values) {
    double most = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) most = std::max(most, std::abs(values[i] - values[i - 1]));
    return most;
}

} // namespace hachure::test
