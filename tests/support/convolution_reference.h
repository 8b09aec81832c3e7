#pragma once

#include <hachure/systems/implicit_brush/convolve_job.h>
#include <hachure/systems/implicit_brush/tip_textures.h>
#include <hachure/tests/support/stamp_images.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

// The convolution of section 4.1 of Vergne et al. 2011 and its tone mapping, in double precision: every stamp over
// every pixel near it, footprints from what footprint.h says of them. Written without a look at the shaders.

namespace hachure::test {

/// A bitmap tip with its levels, each the mean of 2 x 2 texels of the one before; sides are powers of two.
class TipPyramid {
public:
    explicit TipPyramid(const TipImage& image) {
        Level first{image.width, image.height, {}};
        for (int y = image.height - 1; y >= 0; --y) // the bottom row first
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 4; ++c)
                    first.values.push_back(
                        double(image.pixels[static_cast<std::size_t>(4 * (y * image.width + x) + c)]));
        levels_.push_back(first);
        while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
    }

    /// Between texels and between levels; `u`, `v` in [0, 1].
    [[nodiscard]] std::array<double, 4> at(double u, double v, double level) const {
        level = std::clamp(level, 0.0, double(levels_.size()) - 1.0);
        const auto low = static_cast<std::size_t>(std::floor(level));
        const std::size_t high = std::min(low + 1, levels_.size() - 1);
        std::array<double, 4> result{};
        for (std::size_t c = 0; c < 4; ++c)
            result[c] = std::lerp(levels_[low].at(u, v, c), levels_[high].at(u, v, c), level - double(low));
        return result;
    }

    [[nodiscard]] int width() const { return levels_.front().width; }
    [[nodiscard]] int height() const { return levels_.front().height; }

private:
    struct Level {
        int width, height;
        std::vector<double> values;

        [[nodiscard]] double texel(int x, int y, std::size_t c) const {
            x = std::clamp(x, 0, width - 1);
            y = std::clamp(y, 0, height - 1);
            return values[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x)) +
                          c];
        }
        [[nodiscard]] double at(double u, double v, std::size_t c) const {
            const double x = std::clamp(u, 0.0, 1.0) * width - 0.5, y = std::clamp(v, 0.0, 1.0) * height - 0.5;
            const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
            return std::lerp(std::lerp(texel(i, j, c), texel(i + 1, j, c), x - i),
                             std::lerp(texel(i, j + 1, c), texel(i + 1, j + 1, c), x - i), y - j);
        }
    };

    static Level halved(const Level& from) {
        Level to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
        for (int y = 0; y < to.height; ++y)
            for (int x = 0; x < to.width; ++x)
                for (std::size_t c = 0; c < 4; ++c) {
                    double sum = 0.0;
                    for (const int j : {2 * y, 2 * y + 1})
                        for (const int i : {2 * x, 2 * x + 1}) sum += 0.25 * from.texel(i, j, c);
                    to.values.push_back(sum);
                }
        return to;
    }

    std::vector<Level> levels_;
};

/// b of equation 3: the opacity of a footprint at a place from its middle, px.
class FootprintReference {
public:
    FootprintReference(const Footprint& footprint, double radius, double angle, const TipPyramid* bitmap)
        : footprint_(footprint), radius_(radius), across_(radius * double(footprint.aspect)), cosine_(std::cos(angle)),
          sine_(std::sin(angle)), bitmap_(bitmap) {}

    /// Colour and opacity; of all tips but bitmaps the colour is white.
    [[nodiscard]] std::array<double, 4> at(double x, double y) const {
        const double u = cosine_ * x + sine_ * y, v = cosine_ * y - sine_ * x;
        if (footprint_.tip == BrushTip::bitmap) return bitmap_at(u, v);
        const double opacity = opacity_at(x, y, u, v);
        return {opacity, opacity, opacity, opacity};
    }

private:
    [[nodiscard]] double opacity_at(double x, double y, double u, double v) const {
        double sum = 0.0;
        switch (footprint_.tip) {
        case BrushTip::disk:
            for (const double dx : {-0.25, 0.25})
                for (const double dy : {-0.25, 0.25}) sum += 0.25 * disk(x + dx, y + dy, direction_rim(u, v));
            return sum;
        case BrushTip::soft_disk: {
            const double wide = std::max(radius_, 2.0), high = std::max(across_, 2.0);
            const double inside = std::max(0.0, 1.0 - (u * u) / (wide * wide) - (v * v) / (high * high));
            return radius_ * across_ / (wide * high) * inside * inside;
        }
        case BrushTip::line:
            return smoothed(u, radius_) * smoothed(v, double(line_thickness) * across_);
        case BrushTip::bristle:
            for (const glm::vec4& hair : bristle_hairs)
                sum += smoothed(u - double(hair.x) * radius_, double(hair.z) * radius_) *
                       smoothed(v - double(hair.y) * across_, double(hair.w) * across_);
            return sum;
        case BrushTip::splatter:
            for (const glm::vec3& drop : splatter_drops) {
                const double size = double(drop.z) * std::sqrt(radius_ * across_), drawn = std::max(size, 2.0);
                const double d2 = std::pow(u - double(drop.x) * radius_, 2) + std::pow(v - double(drop.y) * across_, 2);
                // From 1 at a squared distance of r^2 - 2 r to 0 at r^2 + 2 r.
                sum += size * size / (drawn * drawn) *
                       std::clamp((drawn * drawn + 2.0 * drawn - d2) / (4.0 * drawn), 0.0, 1.0);
            }
            return sum;
        case BrushTip::bitmap:
            break;
        }
        return 0.0;
    }

    /// The radius of the ellipse in the direction of a place in its axes.
    [[nodiscard]] double direction_rim(double u, double v) const {
        const double wide = std::max(radius_, 1.0), high = std::max(across_, 1.0);
        const double distance = std::hypot(u / wide, v / high);
        if (distance < 1e-3) return std::max(wide, high);
        // Of the place on the rim in that direction: how much the squared unit distance changes there.
        return distance / std::hypot(u / (wide * wide), v / (high * high));
    }

    /// Falls from 1 to 0 around the rim, linearly in the squared unit distance g: by the rim's radius / 2 times g.
    [[nodiscard]] double disk(double x, double y, double rim) const {
        const double wide = std::max(radius_, 1.0), high = std::max(across_, 1.0);
        const double u = cosine_ * x + sine_ * y, v = cosine_ * y - sine_ * x;
        const double g = u * u / (wide * wide) + v * v / (high * high);
        return radius_ * across_ / (wide * high) * std::clamp(0.5 + 0.5 * rim * (1.0 - g), 0.0, 1.0);
    }

    /// The integral of max(0, 1 - |s|) over the part of an interval around 0 that is seen from a place.
    static double smoothed(double place, double half) {
        const auto up_to = [](double s) {
            if (s <= -1.0) return 0.0;
            if (s >= 1.0) return 1.0;
            return s < 0.0 ? 0.5 * (1.0 + s) * (1.0 + s) : 1.0 - 0.5 * (1.0 - s) * (1.0 - s);
        };
        return up_to(half - place) - up_to(-half - place);
    }

    [[nodiscard]] std::array<double, 4> bitmap_at(double u, double v) const {
        const double rim = smoothed(u, radius_) * smoothed(v, across_);
        if (rim <= 0.0) return {};
        const double texels = std::max(bitmap_->width() / (2.0 * std::max(radius_, 0.25)),
                                       bitmap_->height() / (2.0 * std::max(across_, 0.25)));
        std::array<double, 4> value =
            bitmap_->at(0.5 + 0.5 * u / radius_, 0.5 + 0.5 * v / across_, std::max(std::log2(texels), 0.0));
        for (double& channel : value) channel *= rim;
        return value;
    }

    Footprint footprint_;
    double radius_, across_, cosine_, sine_;
    const TipPyramid* bitmap_;
};

/// Ink of every pixel, premultiplied; 4 values a pixel, the bottom row first.
inline std::vector<double> convolution_reference(const StampImage& image, const ConvolveJob& job,
                                                 const TipPyramid* bitmap = nullptr, bool colored_tip = false) {
    std::vector<double> sums(4 * image.stamps.size());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const StampImage::Stamp& stamp = image.at(x, y);
            if (!(stamp.weight > 0.0f)) continue;
            const double radius = double(stamp.radius), weight = double(stamp.weight);
            const FootprintReference form(job.footprint, radius, double(stamp.angle), bitmap);
            const std::array ink = {double(stamp.red), double(stamp.green), double(stamp.blue), weight};
            const int far =
                static_cast<int>(std::ceil(job.footprint.reach(radius) + std::hypot(double(stamp.x), double(stamp.y))));
            for (int j = std::max(y - far, 0); j <= std::min(y + far, image.height - 1); ++j)
                for (int i = std::max(x - far, 0); i <= std::min(x + far, image.width - 1); ++i) {
                    const auto tip = form.at(i - x - double(stamp.x), j - y - double(stamp.y));
                    double* sum = &sums[4 * static_cast<std::size_t>(j * image.width + i)];
                    for (std::size_t c = 0; c < 4; ++c)
                        sum[c] += double(job.radius) / radius * (colored_tip ? weight * tip[c] : ink[c] * tip[3]);
                }
        }
    const double white = job.footprint.mass(double(job.radius)) * double(job.peak), p = double(job.contrast);
    for (std::size_t i = 0; i < image.stamps.size(); ++i) {
        double* sum = &sums[4 * i];
        const double v = sum[3];
        if (v <= 0.0) continue;
        const double f = double(job.opacity) * std::min(p * v / ((p - 1.0) * v + white), 1.0);
        for (int c = 0; c < 3; ++c) sum[c] *= f / v;
        sum[3] = f;
    }
    return sums;
}

} // namespace hachure::test
