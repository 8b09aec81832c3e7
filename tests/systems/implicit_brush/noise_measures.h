#pragma once

#include <hachure/tests/systems/implicit_brush/noise_scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace hachure::test {

/// Which pixels count.
using PixelMask = std::function<bool(int x, int y)>;

inline bool every_pixel(int, int) { return true; }

/// A disk in the middle of the picture.
inline PixelMask middle_disk(const NoiseImage& image, double radius) {
    return [&image, radius](int x, int y) {
        return std::hypot(x + 0.5 - 0.5 * image.width, y + 0.5 - 0.5 * image.height) <= radius;
    };
}

/// Pixels between two changes of a channel's sign along rows and along columns, over all channels: the size of grains.
inline double grain_size(const NoiseImage& image, const PixelMask& mask = every_pixel) {
    std::size_t steps = 0, changes = 0;
    const auto step = [&](int x, int y, int x2, int y2) {
        if (x2 >= image.width || y2 >= image.height || !mask(x, y) || !mask(x2, y2)) return;
        for (int c = 0; c < 4; ++c) {
            ++steps;
            changes += (image.at(x, y)[c] > 0.0f) != (image.at(x2, y2)[c] > 0.0f);
        }
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            step(x, y, x + 1, y);
            step(x, y, x, y + 1);
        }
    return static_cast<double>(steps) / static_cast<double>(changes);
}

/// Moments of the channels.
struct NoiseStatistics {
    std::array<double, 4> mean{}, variance{};
    std::array<std::array<double, 10>, 4> histogram{}; ///< parts of the pixels, by tenths of [-1, 1]
    double correlation = 0.0;                          ///< the largest between two channels
    bool in_range = true;                              ///< all are numbers from -1 to 1
};

inline NoiseStatistics statistics(const NoiseImage& image, const PixelMask& mask = every_pixel) {
    NoiseStatistics result;
    std::array<std::array<double, 4>, 4> products{};
    double count = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (!mask(x, y)) continue;
            const glm::vec4& value = image.at(x, y);
            count += 1.0;
            for (int a = 0; a < 4; ++a) {
                result.in_range = result.in_range && value[a] >= -1.0f && value[a] <= 1.0f;
                result.mean[a] += value[a];
                result.histogram[a][std::clamp(static_cast<int>(5.0f * (value[a] + 1.0f)), 0, 9)] += 1.0;
                for (int b = 0; b < 4; ++b) products[a][b] += static_cast<double>(value[a]) * value[b];
            }
        }
    for (int a = 0; a < 4; ++a) {
        result.mean[a] /= count;
        for (double& part : result.histogram[a]) part /= count;
    }
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b) {
            const double covariance = products[a][b] / count - result.mean[a] * result.mean[b];
            if (a == b)
                result.variance[a] = covariance;
            else
                result.correlation =
                    std::max(result.correlation, std::abs(covariance) / std::sqrt(result.variance[b] / 3.0));
        }
    return result;
}

/// Root of the mean squared difference between two pictures.
inline double difference(const NoiseImage& a, const NoiseImage& b, const PixelMask& mask = every_pixel) {
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (!mask(x, y)) continue;
            const glm::vec4 d = a.at(x, y) - b.at(x, y);
            sum += static_cast<double>(glm::dot(d, d));
            count += 4.0;
        }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

/// The largest difference of a channel anywhere.
inline double largest_difference(const NoiseImage& a, const NoiseImage& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        for (int c = 0; c < 4; ++c)
            largest = std::max(largest, static_cast<double>(std::abs(a.values[i][c] - b.values[i][c])));
    return largest;
}

/// Between pixels; places are those of pixels' corners, so that the first one's middle is at .5.
inline glm::vec4 between_pixels(const NoiseImage& image, glm::vec2 place) {
    const glm::vec2 p = place - 0.5f;
    const auto x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
    const glm::vec2 t = glm::fract(p);
    return glm::mix(glm::mix(image.at(x, y), image.at(x + 1, y), t.x),
                    glm::mix(image.at(x, y + 1), image.at(x + 1, y + 1), t.x), t.y);
}

/// RMS difference between a frame and the one before, moved by the motion since then. `velocity` has pixels right and
/// up in x and y. `mask` says which pixels show what the frame before showed at the place that they came from.
inline double moved_difference(const NoiseImage& now, const NoiseImage& before, const NoiseImage& velocity,
                               const PixelMask& mask) {
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < now.height; ++y)
        for (int x = 0; x < now.width; ++x) {
            if (!mask(x, y)) continue;
            const glm::vec2 from = glm::vec2(x, y) + 0.5f - glm::vec2(velocity.at(x, y));
            if (from.x < 1.0f || from.y < 1.0f || from.x > static_cast<float>(now.width) - 2.0f ||
                from.y > static_cast<float>(now.height) - 2.0f)
                continue;
            const glm::vec4 d = now.at(x, y) - between_pixels(before, from);
            sum += static_cast<double>(glm::dot(d, d));
            count += 4.0;
        }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

} // namespace hachure::test
