#pragma once

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

/// What a set of stripes is drawn from (Gooch 1998, section 4.3: "random intensities between 0.0 and 0.5").
struct StripeSet {
    std::uint32_t seed = 1;
    std::uint32_t count = 20; ///< >= 2
    float low = 0.0f, high = 0.5f;
    /// How sets follow each other: each like the one before, or each the mirror image of it.
    bool mirrored = false;

    friend bool operator==(const StripeSet&, const StripeSet&) = default;
};

/// Intensity of stripe `index`: uniform in [low, high), a function of seed and index alone. Where high < low the two
/// change places.
[[nodiscard]] double stripe_intensity(const StripeSet& set, std::uint32_t index);

/// The stripes as a function c(x) of period `knots.size()` that is linear between whole numbers, where the centres of
/// the stripes lie; with its first and second antiderivatives, as shaders/metal/ramp.glsl filters it.
struct StripeRamp {
    double mean = 0.0;
    /// By stripe i: c(i) - mean, the slope from i to i + 1, and C(i) and D(i) with C' = c - mean, D' = C, both periodic
    /// and of mean 0. One period: `count` stripes, or twice as many where sets are mirrored.
    std::vector<glm::vec4> knots;
};

[[nodiscard]] StripeRamp make_stripe_ramp(const StripeSet& set);

} // namespace hachure
