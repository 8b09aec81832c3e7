#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace hachure::test {

/// Tones (0 black, 1 white) in rows from the bottom, as textures have them. Pixel (x, y) has its centre at
/// (x + .5, y + .5).
struct Tones {
    int width = 0, height = 0;
    std::vector<double> values;

    Tones(int w, int h, double tone = 1.0)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), tone) {}

    double& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] double at(int x, int y) const { return const_cast<Tones*>(this)->at(x, y); }

    /// Beyond the border the nearest pixel's.
    [[nodiscard]] double clamped(int x, int y) const {
        return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    }
};

inline glm::dvec2 pixel_center(int x, int y) { return {x + 0.5, y + 0.5}; }

/// A straight line with a direction across: the truth that what is found is compared with.
struct TrueLine {
    glm::dvec2 normal{1.0, 0.0};
    double offset = 0.0;

    /// Through the middle of a picture, `phase` pixels aside, its normal at `angle` radians from the x axis.
    static TrueLine through_middle(int width, int height, double angle, double phase) {
        const glm::dvec2 normal(std::cos(angle), std::sin(angle));
        return {normal, glm::dot(normal, 0.5 * glm::dvec2(width, height)) + phase};
    }

    /// Pixels from `p` to the line, positive on the side of the normal.
    [[nodiscard]] double distance(glm::dvec2 p) const { return glm::dot(normal, p) - offset; }
};

/// Profiles across a line, integrated twice from minus infinity: what the mean over a pixel is made of. The mean over a
/// square is a convolution with a trapezoid, which is one box for each side of the square, and a box is a difference of
/// the integral.
namespace profile {

/// 0, from u = 0 on 1.
struct Step {
    [[nodiscard]] double twice(double u) const { return u > 0.0 ? 0.5 * u * u : 0.0; }
    [[nodiscard]] double once(double u) const { return std::max(u, 0.0); }
};

/// 1 for |u| < h, 0 before it and `beyond` behind it.
struct Bar {
    double h = 1.0, beyond = 0.0;

    [[nodiscard]] double twice(double u) const { return Step{}.twice(u + h) - (1.0 - beyond) * Step{}.twice(u - h); }
    [[nodiscard]] double once(double u) const { return Step{}.once(u + h) - (1.0 - beyond) * Step{}.once(u - h); }
};

/// exp(-u^2 / 2 s^2)
struct Ridge {
    double s = 1.0;

    [[nodiscard]] double once(double u) const {
        return s * std::sqrt(std::numbers::pi / 2.0) * std::erfc(-u / (s * std::numbers::sqrt2));
    }
    [[nodiscard]] double twice(double u) const { return u * once(u) + s * s * std::exp(-0.5 * u * u / (s * s)); }
};

} // namespace profile

/// The mean of a profile over the pixel whose centre is `u` from the line.
template <class Profile> double pixel_mean(const Profile& profile, double u, glm::dvec2 normal) {
    const double a = 0.5 * std::abs(normal.x), b = 0.5 * std::abs(normal.y);
    const double wide = std::max(a, b), narrow = std::min(a, b);
    // A difference of differences would lose its digits, and what it adds is of the square of `narrow`.
    if (narrow < 1e-5) return (profile.once(u + wide) - profile.once(u - wide)) / (2.0 * wide);
    const auto difference = [&](double v) { return profile.twice(v + narrow) - profile.twice(v - narrow); };
    return (difference(u + wide) - difference(u - wide)) / (4.0 * wide * narrow);
}

/// A line on a background: exact means over the pixels. Contrast is what the profile's 1 adds: negative for dark lines.
template <class Profile>
Tones draw_line(int width, int height, const TrueLine& line, const Profile& profile, double background,
                double contrast) {
    Tones tones(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            tones.at(x, y) =
                background + contrast * pixel_mean(profile, line.distance(pixel_center(x, y)), line.normal);
    return tones;
}

/// As a rasteriser sees it: the mean of n x n points of a pixel, of a function of the place.
template <class Function> Tones draw_points(int width, int height, int n, const Function& tone) {
    Tones tones(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) sum += tone(glm::dvec2(x + (i + 0.5) / n, y + (j + 0.5) / n));
            tones.at(x, y) = sum / (n * n);
        }
    return tones;
}

/// The area of [0, x] x [0, y] in a circle around the origin, with the sign of x y.
inline double circle_quadrant_area(double r, double x, double y) {
    const double sign = (x < 0.0) != (y < 0.0) ? -1.0 : 1.0;
    x = std::min(std::abs(x), r), y = std::min(std::abs(y), r);
    if (x * x + y * y <= r * r) return sign * x * y;
    const auto under_arc = [&](double t) { return 0.5 * (t * std::sqrt(r * r - t * t) + r * r * std::asin(t / r)); };
    const double leaves = std::sqrt(r * r - y * y); // where the arc falls below y
    return sign * (leaves * y + under_arc(x) - under_arc(leaves));
}

/// The part of a pixel inside a circle.
inline double circle_coverage(glm::dvec2 center, double r, int x, int y) {
    const double x0 = x - center.x, y0 = y - center.y, x1 = x0 + 1.0, y1 = y0 + 1.0;
    return circle_quadrant_area(r, x1, y1) - circle_quadrant_area(r, x0, y1) - circle_quadrant_area(r, x1, y0) +
           circle_quadrant_area(r, x0, y0);
}

/// A ring with its middle at radius r: exact means over the pixels.
inline Tones draw_ring(int width, int height, glm::dvec2 center, double r, double half_width, double background,
                       double contrast) {
    Tones tones(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            tones.at(x, y) = background + contrast * (circle_coverage(center, r + half_width, x, y) -
                                                      circle_coverage(center, r - half_width, x, y));
    return tones;
}

/// A normally distributed number for every pixel, the same for the same seed.
inline double normal_noise(std::uint64_t seed, std::uint64_t index) {
    const auto uniform = [&](std::uint64_t which) { // SplitMix64's finaliser of a counter
        std::uint64_t x = seed * 0x9e3779b97f4a7c15u + 2 * index + which + 1;
        x *= 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return (static_cast<double>((x ^ (x >> 31)) >> 11) + 0.5) / 9007199254740992.0;
    };
    return std::sqrt(-2.0 * std::log(uniform(0))) * std::cos(2.0 * std::numbers::pi * uniform(1));
}

inline void add_noise(Tones& tones, double deviation, std::uint64_t seed) {
    if (deviation <= 0.0) return;
    for (std::size_t i = 0; i < tones.values.size(); ++i) tones.values[i] += deviation * normal_noise(seed, i);
}

/// A phase for the k-th of many lines, in [0, 1): spread evenly, however many there are.
inline double spread_phase(int k) { return std::fmod(0.5 + 0.6180339887498949 * k, 1.0); }

} // namespace hachure::test
