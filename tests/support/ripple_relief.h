#pragma once

#include <hachure/tests/support/brush_reference.h>
#include <hachure/tests/support/ripple_score.h>

#include <functional>
#include <vector>

/// The ripple as a picture: rings about a place that is no pixel's, 38 px from one to the next.
namespace hachure::test::ripple {

inline constexpr int size = 256;     ///< px
inline constexpr double scale = 6.0; ///< px of a unit of the radius
inline const glm::dvec2 middle(128.3, 127.6);

/// Where a height over the radius (units) has its lines, and what a profile of `window` px says of them.
inline std::vector<TrueCircle> circles(const std::function<double(double)>& height, double window) {
    std::vector<TrueCircle> all;
    for (const double r : maxima(height, 2.5, 24.0)) {
        constexpr double step = 1e-3;
        const double second = (height(r + step) - 2.0 * height(r) + height(r - step)) / (step * step);
        all.push_back({scale * r, height(r), -second / (scale * scale) * window * window / 8.0});
    }
    return all;
}

inline std::vector<TrueCircle> scaled(std::vector<TrueCircle> all, double factor) {
    for (TrueCircle& c : all) c.height *= factor, c.curvature *= factor;
    return all;
}

/// What is found counts above half of the faintest line's height: what a brush for that line would ask for.
inline RippleScore score(const std::vector<PixelProfile>& profiles, const std::vector<TrueCircle>& truth) {
    RippleScore result(middle, 2.2 * scale, 20.0 * scale, 2.0, truth);
    result.add(profiles, size, 0.5 * truth.back().height);
    return result;
}

/// A relief that rises by `rise` per pixel at a radius (units), away from the middle.
inline SlopeImage relief(const std::function<double(double)>& rise) {
    return SlopeImage::of(size, size, [&](glm::dvec2 p) {
        const glm::dvec2 d = p - middle;
        const double r = glm::length(d);
        return rise(r / scale) * d / r;
    });
}

} // namespace hachure::test::ripple
