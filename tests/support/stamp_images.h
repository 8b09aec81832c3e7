#pragma once

#include <hachure/runtime/assets/image.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace hachure::test {

/// What the pixels of a picture stamp, as brushes have it in their textures; the bottom row first.
struct StampImage {
    struct Stamp {
        float x = 0.0f, y = 0.0f;                                   ///< middle, px from the pixel's centre
        float radius = 1.0f;                                        ///< px
        float angle = 0.0f;                                         ///< rad
        float red = 0.0f, green = 0.0f, blue = 0.0f, weight = 0.0f; ///< colours times weight
    };

    StampImage(int w, int h) : width(w), height(h), stamps(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    [[nodiscard]] Stamp& at(int x, int y) { return stamps[index(x, y)]; }
    [[nodiscard]] const Stamp& at(int x, int y) const { return stamps[index(x, y)]; }

    [[nodiscard]] std::size_t active() const {
        return static_cast<std::size_t>(std::ranges::count_if(stamps, [](const Stamp& s) { return s.weight > 0.0f; }));
    }

    int width, height;
    std::vector<Stamp> stamps;

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Of stamps that vary: how far they move, and which part of their size they lose.
struct StampVariety {
    double shift = 0.0; ///< px
    double shrink = 0.0;
    bool turned = true;
    bool colored = true;
};

/// A stamp whose weight falls with the distance from a line as a Gaussian does, and is none below 1/255; its other
/// values wave over the picture.
inline StampImage::Stamp stamp_near_line(double distance, double spread, double radius, double x, double y,
                                         const StampVariety& variety) {
    StampImage::Stamp stamp;
    const double weight = std::exp(-0.5 * distance * distance / (spread * spread));
    if (weight < 1.0 / 255.0) return stamp;
    const auto wave = [&](double phase) { return std::sin(0.11 * x + 0.07 * y + phase); };
    stamp.weight = static_cast<float>(weight);
    stamp.radius = static_cast<float>(radius * (1.0 - variety.shrink * (0.5 + 0.5 * wave(0.3))));
    stamp.angle = variety.turned ? static_cast<float>(0.05 * x - 0.03 * y) : 0.0f;
    stamp.x = static_cast<float>(variety.shift * 0.7 * wave(2.0));
    stamp.y = static_cast<float>(variety.shift * 0.7 * wave(4.0));
    if (!variety.colored) return stamp;
    stamp.red = static_cast<float>(weight * (0.5 + 0.5 * wave(1.0)));
    stamp.green = static_cast<float>(weight * (0.5 - 0.5 * wave(2.5)));
    stamp.blue = static_cast<float>(weight * 0.25);
    return stamp;
}

/// Stamps along all places where `distance` (x, y of pixels' centres) is near 0.
inline StampImage stamps_along(int width, int height, const std::function<double(double, double)>& distance,
                               double spread, double radius, const StampVariety& variety = {}) {
    StampImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = stamp_near_line(distance(x + 0.5, y + 0.5), spread, radius, x, y, variety);
    return image;
}

/// A ring and a line through it: places of little and of much curvature, and crossings.
inline StampImage crossed_ring(int width, int height, double spread, double radius, const StampVariety& variety = {}) {
    const double size = std::min(width, height);
    return stamps_along(
        width, height,
        [=](double x, double y) {
            const double u = x - 0.5 * width, v = y - 0.47 * height;
            return std::min(std::abs(std::hypot(u, v) - 0.3 * size), std::abs(0.8 * u - 0.6 * v));
        },
        spread, radius, variety);
}

/// Stamps where the normals of a frame (3 channels or more, the top row first) turn: across how they turn, with weights
/// that follow how fast. Pixels of no length of normal, and those beside the border, stamp nothing.
inline StampImage stamps_of_normals(const assets::Image& normals, double low, double high, double radius,
                                    const StampVariety& variety = {}) {
    StampImage image(normals.width, normals.height);
    const auto normal = [&](int x, int y, int c) {
        const auto row = static_cast<std::size_t>(normals.height - 1 - y);
        const std::size_t texel = row * static_cast<std::size_t>(normals.width) + static_cast<std::size_t>(x);
        return double(normals.f32()[texel * static_cast<std::size_t>(normals.channels) + static_cast<std::size_t>(c)]);
    };
    for (int y = 1; y + 1 < image.height; ++y)
        for (int x = 1; x + 1 < image.width; ++x) {
            double xx = 0.0, yy = 0.0, xy = 0.0, length = 0.0;
            for (int c = 0; c < 3; ++c) {
                const double dx = 0.5 * (normal(x + 1, y, c) - normal(x - 1, y, c));
                const double dy = 0.5 * (normal(x, y + 1, c) - normal(x, y - 1, c));
                xx += dx * dx;
                yy += dy * dy;
                xy += dx * dy;
                length += normal(x, y, c) * normal(x, y, c);
            }
            const double turns = std::sqrt(xx + yy), part = std::clamp((turns - low) / (high - low), 0.0, 1.0);
            const double weight = part * part * (3.0 - 2.0 * part);
            if (length < 0.25 || weight < 1.0 / 255.0) continue;
            StampImage::Stamp& stamp = image.at(x, y);
            stamp = stamp_near_line(0.0, 1.0, radius, x, y, variety);
            stamp.weight = static_cast<float>(weight);
            stamp.red *= stamp.weight;
            stamp.green *= stamp.weight;
            stamp.blue *= stamp.weight;
            if (variety.turned) stamp.angle = static_cast<float>(0.5 * std::atan2(2.0 * xy, xx - yy));
        }
    return image;
}

} // namespace hachure::test
