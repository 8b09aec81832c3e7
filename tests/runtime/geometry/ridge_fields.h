#pragma once

#include <hachure/runtime/geometry/trace_ridges.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

namespace hachure::geometry {

/// A RidgeImage that owns its pixels.
struct RidgeField {
    int width, height;
    std::vector<glm::vec4> points, directions;
    std::vector<std::uint32_t> owners;

    RidgeField(int w, int h)
        : width(w), height(h), points(static_cast<std::size_t>(w * h)), directions(points.size()),
          owners(points.size()) {}

    [[nodiscard]] RidgeImage image() const { return {width, height, points, directions, owners}; }
    void set(int x, int y, glm::dvec2 offset, double curvature, double opacity, glm::dvec2 tangent, double line_width,
             std::uint32_t owner = 1) {
        const auto i = static_cast<std::size_t>(y * width + x);
        points[i] = glm::vec4(glm::vec2(offset), static_cast<float>(curvature), static_cast<float>(opacity));
        directions[i] = glm::vec4(glm::vec2(tangent), static_cast<float>(line_width), 0.0f);
        owners[i] = owner;
    }
};

using Tone = std::function<double(glm::dvec2)>;

/// A dark bar of that width as a blur of deviation width / 2 leaves it, in closed form: `across` is how far away its
/// middle is.
inline double blurred_bar(double across, double width, double contrast = 0.8) {
    const double scale = 1.0 / (std::numbers::sqrt2 * 0.5 * width);
    return contrast * 0.5 * (std::erf((across + 0.5 * width) * scale) - std::erf((across - 0.5 * width) * scale));
}

/// How much of a half plane's light a blur leaves, `inside` pixels from its rim.
inline double blurred_step(double inside, double width) {
    return 0.5 * (1.0 + std::erf(inside / (std::numbers::sqrt2 * 0.5 * width)));
}

/// What the method of Lee et al. finds in a tone image (section 3.2, with the readings of docs/abstracted-lines.md), in
/// double precision and on tones in closed form: nothing here is shared with the shaders.
inline RidgeField find_ridges(int width, int height, double line_width, const Tone& tone, double low = 0.01,
                              double high = 0.03) {
    RidgeField field(width, height);
    const double h = 0.5 * line_width;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 pixel(x + 0.5, y + 0.5);
            glm::dvec2 at = pixel, across(0.0);
            double curvature = 0.0;
            bool found = false;
            for (int step = 0; step < 6; ++step) {
                double t[3][3];
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i < 3; ++i) t[j][i] = tone(at + h * glm::dvec2(i - 1, j - 1));
                const double w[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
                double gx = 0, gy = 0, xx = 0, yy = 0;
                for (int k = 0; k < 3; ++k) {
                    gx += w[k] * 0.5 * (t[k][2] - t[k][0]);
                    gy += w[k] * 0.5 * (t[2][k] - t[0][k]);
                    xx += w[k] * (t[k][2] - 2 * t[k][1] + t[k][0]);
                    yy += w[k] * (t[2][k] - 2 * t[1][k] + t[0][k]);
                }
                const double xy = 0.25 * (t[2][2] - t[2][0] - t[0][2] + t[0][0]);
                const double mean = 0.5 * (xx + yy), root = std::hypot(0.5 * (xx - yy), xy);
                const double lambda = mean >= 0 ? mean + root : mean - root;
                curvature = 0.5 * lambda;
                found = std::abs(curvature) > low;
                if (!found) break;
                const double angle = 0.5 * std::atan2(2 * xy, xx - yy) + (mean >= 0 ? 0.0 : std::numbers::pi / 2);
                across = {std::cos(angle), std::sin(angle)};
                at += h * std::clamp(-(gx * across.x + gy * across.y) / lambda, -1.0, 1.0) * across;
            }
            if (!found || glm::distance(at, pixel) > h + 1.5) continue;
            const double s = std::clamp((std::abs(curvature) - low) / (high - low), 0.0, 1.0);
            field.set(x, y, at - pixel, curvature, s * s * (3 - 2 * s), {-across.y, across.x}, line_width);
        }
    }
    return field;
}

} // namespace hachure::geometry
