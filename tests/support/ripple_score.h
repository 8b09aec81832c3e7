#pragma once

#include <hachure/tests/support/feature_finding.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hachure::test {

/// A circle that a line is on.
struct TrueCircle {
    double radius = 0.0;                  ///< px
    double height = 0.0, curvature = 0.0; ///< of its profile; 0 where nobody asks
};

/// How well profiles find concentric circles.
class RippleScore {
public:
    /// Pixels from `inner` to `outer` px from the middle count; those within `near` px of a circle have to find it.
    RippleScore(glm::dvec2 middle, double inner, double outer, double near, std::vector<TrueCircle> circles)
        : middle_(middle), inner_(inner), outer_(outer), near_(near), circles_(std::move(circles)),
          spread_(circles_.size()) {}

    void add(const std::vector<PixelProfile>& profiles, int width, double least_height) {
        for (std::size_t i = 0; i < profiles.size(); ++i) {
            const glm::dvec2 p = pixel_center(static_cast<int>(i) % width, static_cast<int>(i) / width);
            const double r = glm::distance(p, middle_);
            if (r < inner_ || r > outer_) continue;
            const TrueCircle& at = nearest(r);
            const bool expected = std::abs(r - at.radius) <= near_;
            const PixelProfile& profile = profiles[i];
            const double place = glm::distance(p + profile.offset, middle_);
            if (expected) {
                const double off = profile.height < least_height ? near_ : std::abs(place - at.radius);
                expected_ += 1.0, all_squares_ += std::min(off * off, near_ * near_);
            }
            if (profile.height < least_height || place < inner_ || place > outer_) continue;
            const TrueCircle& line = nearest(place);
            const double error = std::abs(place - line.radius);
            found_ += 1.0;
            if (error > 0.25) continue;
            right_ += 1.0;
            if (!expected) continue;
            recalled_ += 1.0, squares_ += error * error, largest_ = std::max(largest_, error);
            height_error_ = std::max(height_error_, std::abs(profile.height / line.height - 1.0));
            spread_[static_cast<std::size_t>(&line - circles_.data())].add(profile);
        }
    }

    [[nodiscard]] double rms() const { return std::sqrt(squares_ / recalled_); }
    /// The same with all that should be found: what is farther than `near`, or is not found, is as far as that.
    [[nodiscard]] double rms_of_all() const { return std::sqrt(all_squares_ / expected_); }
    [[nodiscard]] double largest() const { return largest_; } ///< px
    [[nodiscard]] double recall() const { return recalled_ / expected_; }
    [[nodiscard]] double precision() const { return right_ / found_; }
    [[nodiscard]] double height_error() const { return height_error_; } ///< the largest, as a part
    /// How far heights and curvatures of a line differ from their mean, at most, as a part.
    [[nodiscard]] double height_spread() const {
        double most = 0.0;
        for (const Spread& s : spread_) most = std::max(most, s.height.relative());
        return most;
    }
    [[nodiscard]] double curvature_spread() const {
        double most = 0.0;
        for (const Spread& s : spread_) most = std::max(most, s.curvature.relative());
        return most;
    }
    [[nodiscard]] double curvature_error(std::size_t circle) const {
        const Range& c = spread_[circle].curvature;
        return 0.5 * (c.least + c.most) / circles_[circle].curvature - 1.0;
    }

private:
    struct Range {
        double least = 1e9, most = -1e9;
        void add(double v) { least = std::min(least, v), most = std::max(most, v); }
        [[nodiscard]] double relative() const { return most > least ? (most - least) / (most + least) : 0.0; }
    };
    struct Spread {
        Range height, curvature;
        void add(const PixelProfile& p) { height.add(p.height), curvature.add(p.curvature); }
    };

    [[nodiscard]] const TrueCircle& nearest(double r) const {
        return *std::ranges::min_element(circles_, {}, [&](const TrueCircle& c) { return std::abs(c.radius - r); });
    }

    glm::dvec2 middle_;
    double inner_, outer_, near_;
    std::vector<TrueCircle> circles_;
    double expected_ = 0.0, found_ = 0.0, right_ = 0.0, recalled_ = 0.0, squares_ = 0.0, largest_ = 0.0;
    double all_squares_ = 0.0;
    double height_error_ = 0.0;
    std::vector<Spread> spread_;
};

} // namespace hachure::test
