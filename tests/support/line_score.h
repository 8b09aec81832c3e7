#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hachure::test {

/// How well drawn pixels agree with a line of known place and width.
class LineScore {
public:
    explicit LineScore(double width) : half_(0.5 * width) {}

    /// A pixel whose centre is `distance` from the line (with sign), is drawn with `opacity`, and takes the line to be
    /// `found` away (same sign). Pixels that rounding could count either way are left out.
    void add(double distance, double opacity, double found) {
        const double d = std::abs(distance);
        opacity_ += opacity;
        covered_ += std::clamp(half_ + 0.5 - d, 0.0, 1.0);
        if (!std::isfinite(opacity) || !std::isfinite(found)) ++not_finite_;
        if (std::abs(d - half_) < 1e-5) return;
        const bool inside = d < half_, drawn = opacity >= 0.5;
        inside_ += inside ? 1 : 0;
        drawn_ += drawn ? 1 : 0;
        if (!inside || !drawn) return;
        ++both_;
        const double error = std::abs(found - distance);
        squares_ += error * error;
        most_ = std::max(most_, error);
    }

    void add_curvature(double c) {
        least_curvature_ = std::min(least_curvature_, c);
        most_curvature_ = std::max(most_curvature_, c);
    }

    [[nodiscard]] double rms() const { return std::sqrt(squares_ / std::max(1.0, both_)); } ///< of the place, pixels
    [[nodiscard]] double most() const { return most_; }                                     ///< error, pixels
    [[nodiscard]] double recall() const {
        return both_ / std::max(1.0, inside_);
    } ///< of pixels up to half a width away
    [[nodiscard]] double precision() const { return both_ / std::max(1.0, drawn_); }
    [[nodiscard]] double band() const { return opacity_ / covered_; } ///< width drawn over width asked for
    [[nodiscard]] std::size_t not_finite() const { return not_finite_; }
    /// How much the curvature on the line varies: (most - least) / middle.
    [[nodiscard]] double curvature_spread() const {
        return 2.0 * (most_curvature_ - least_curvature_) / (most_curvature_ + least_curvature_);
    }
    [[nodiscard]] double least_curvature() const { return least_curvature_; }
    [[nodiscard]] double most_curvature() const { return most_curvature_; }

private:
    double half_;
    double opacity_ = 0.0, covered_ = 0.0, squares_ = 0.0, most_ = 0.0;
    double inside_ = 0.0, drawn_ = 0.0, both_ = 0.0;
    double least_curvature_ = std::numeric_limits<double>::max(), most_curvature_ = 0.0;
    std::size_t not_finite_ = 0;
};

} // namespace hachure::test
