#include <hachure/runtime/picture/flip.h>

#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

// LDR-FLIP; names and figures are those of the paper and of its reference implementation. All filters are sums of
// separable ones.
namespace hachure::picture {
namespace {

using glm::dvec3;

constexpr double pixels_per_degree = 0.7 * 3840.0 / 0.7 * std::numbers::pi / 180.0; // 0.7 m from a 0.7 m wide 4K screen

using Plane = std::vector<double>;

struct Size {
    int width, height;
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(std::clamp(x, 0, width - 1));
    }
};

struct Colors {
    Size size;
    std::array<Plane, 3> planes;
    [[nodiscard]] dvec3 get(std::size_t i) const { return {planes[0][i], planes[1][i], planes[2][i]}; }
};

/// A filter of odd length about its middle, along x and then along y; edges are repeated.
Plane convolve(const Plane& in, Size size, const Plane& along_x, const Plane& along_y) {
    const int radius = static_cast<int>(along_x.size()) / 2;
    Plane rows(in.size()), out(in.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double sum = 0.0;
            for (int k = -radius; k <= radius; ++k)
                sum += along_x[static_cast<std::size_t>(k + radius)] * in[size.at(x + k, y)];
            rows[size.at(x, y)] = sum;
        }
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double sum = 0.0;
            for (int k = -radius; k <= radius; ++k)
                sum += along_y[static_cast<std::size_t>(k + radius)] * rows[size.at(x, y + k)];
            out[size.at(x, y)] = sum;
        }
    return out;
}

Plane sampled(int radius, const std::function<double(double)>& f) {
    Plane kernel;
    for (int k = -radius; k <= radius; ++k) kernel.push_back(f(k));
    return kernel;
}

double sum_of(
    const Plane& kernel, const std::function<bool(double)>& which = [](double) { return true; }) {
    double sum = 0.0;
    for (const double value : kernel)
        if (which(value)) sum += value;
    return sum;
}

// Columns of linear RGB to XYZ (D65), and the white that they add up to.
const glm::dmat3 xyz_from_rgb(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0,
                              8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0,
                              4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0);
const dvec3 white = xyz_from_rgb * dvec3(1.0);

double linear_from_srgb(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

dvec3 ycxcz_from_linear(const dvec3& rgb) {
    const dvec3 t = xyz_from_rgb * rgb / white;
    return {116.0 * t.y - 16.0, 500.0 * (t.x - t.y), 200.0 * (t.y - t.z)};
}

dvec3 linear_from_ycxcz(const dvec3& c) {
    const double y = (c.x + 16.0) / 116.0;
    return glm::inverse(xyz_from_rgb) * (dvec3(y + c.y / 500.0, y, y - c.z / 200.0) * white);
}

/// L*a*b*, with the Hunt effect: colours of dark things look less colourful.
dvec3 hunt_lab(const dvec3& rgb) {
    const dvec3 t = xyz_from_rgb * rgb / white;
    const auto f = [](double v) {
        constexpr double delta = 6.0 / 29.0;
        return v > delta * delta * delta ? std::cbrt(v) : v / (3.0 * delta * delta) + 4.0 / 29.0;
    };
    const double l = 116.0 * f(t.y) - 16.0;
    return {l, 0.01 * l * 500.0 * (f(t.x) - f(t.y)), 0.01 * l * 200.0 * (f(t.y) - f(t.z))};
}

double hyab(const dvec3& a, const dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

Colors ycxcz_of(const assets::Image& image) {
    Colors result{{image.width, image.height}, {}};
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (Plane& plane : result.planes) plane.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        dvec3 rgb;
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c);
            const double s = image.type == assets::PixelType::u8 ? image.u8()[at] / 255.0 : double(image.f32()[at]);
            rgb[c] = linear_from_srgb(std::clamp(s, 0.0, 1.0));
        }
        const dvec3 color = ycxcz_from_linear(rgb);
        for (int c = 0; c < 3; ++c) result.planes[static_cast<std::size_t>(c)][i] = color[c];
    }
    return result;
}

/// One Gaussian of a contrast sensitivity function, as the paper's table 1 has them.
struct Sensitivity {
    double a, b;
};

/// The plane as the eye resolves it.
Plane contrast_filtered(const Plane& plane, Size size, std::span<const Sensitivity> terms) {
    constexpr double widest = 0.04;
    const int radius = static_cast<int>(
        std::ceil(3.0 * std::sqrt(widest / (2.0 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
    Plane result(plane.size(), 0.0);
    double total = 0.0;
    for (const Sensitivity& term : terms) {
        const Plane kernel = sampled(radius, [&](double x) {
            return std::exp(-std::numbers::pi * std::numbers::pi * x * x /
                            (pixels_per_degree * pixels_per_degree * term.b));
        });
        const double weight = term.a * std::sqrt(std::numbers::pi / term.b);
        total += weight * sum_of(kernel) * sum_of(kernel);
        const Plane filtered = convolve(plane, size, kernel, kernel);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] += weight * filtered[i];
    }
    for (double& value : result) value /= total;
    return result;
}

std::vector<dvec3> seen_colors(const Colors& colors) {
    constexpr std::array<Sensitivity, 1> achromatic{{{1.0, 0.0047}}}, red_green{{{1.0, 0.0053}}};
    constexpr std::array<Sensitivity, 2> blue_yellow{{{34.1, 0.04}, {13.5, 0.025}}};
    const Colors filtered{colors.size,
                          {contrast_filtered(colors.planes[0], colors.size, achromatic),
                           contrast_filtered(colors.planes[1], colors.size, red_green),
                           contrast_filtered(colors.planes[2], colors.size, blue_yellow)}};
    std::vector<dvec3> result;
    for (std::size_t i = 0; i < filtered.planes[0].size(); ++i)
        result.push_back(hunt_lab(glm::clamp(linear_from_ycxcz(filtered.get(i)), 0.0, 1.0)));
    return result;
}

/// Compresses large differences of colour, of which the eye tells no degrees.
double color_error(const dvec3& a, const dvec3& b) {
    constexpr double power = 0.7, knee = 0.4, knee_error = 0.95;
    static const double largest = std::pow(hyab(hunt_lab({0.0, 1.0, 0.0}), hunt_lab({0.0, 0.0, 1.0})), power);
    const double difference = std::pow(hyab(a, b), power);
    const double at_knee = knee * largest;
    if (difference < at_knee) return difference * knee_error / at_knee;
    return std::min(1.0, knee_error + (difference - at_knee) / (largest - at_knee) * (1.0 - knee_error));
}

struct Features {
    Plane edges, points;
};

Plane magnitude(const Plane& luminance, Size size, Plane kernel, const Plane& gaussian) {
    const double positive = sum_of(kernel, [](double v) { return v > 0.0; });
    const double negative = -sum_of(kernel, [](double v) { return v < 0.0; });
    for (double& value : kernel) value /= (value > 0.0 ? positive : negative) * sum_of(gaussian);
    Plane result = convolve(luminance, size, kernel, gaussian);
    const Plane vertical = convolve(luminance, size, gaussian, kernel);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(result[i], vertical[i]);
    return result;
}

Features features_of(const Colors& colors) {
    const double deviation = 0.5 * 0.082 * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
    const Plane gaussian = sampled(radius, gauss);
    Plane luminance = colors.planes[0];
    for (double& value : luminance) value = (value + 16.0) / 116.0;
    return {magnitude(luminance, colors.size, sampled(radius, [&](double x) { return -x * gauss(x); }), gaussian),
            magnitude(luminance, colors.size,
                      sampled(radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gauss(x); }),
                      gaussian)};
}

} // namespace

std::vector<float> flip_error(const assets::Image& a, const assets::Image& b) {
    const Colors colors_a = ycxcz_of(a), colors_b = ycxcz_of(b);
    const std::vector<dvec3> seen_a = seen_colors(colors_a), seen_b = seen_colors(colors_b);
    const Features features_a = features_of(colors_a), features_b = features_of(colors_b);
    std::vector<float> errors(seen_a.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double feature = std::max(std::abs(features_a.edges[i] - features_b.edges[i]),
                                        std::abs(features_a.points[i] - features_b.points[i]));
        const double feature_error = std::sqrt(feature / std::numbers::sqrt2);
        errors[i] = static_cast<float>(std::pow(color_error(seen_a[i], seen_b[i]), 1.0 - feature_error));
    }
    return errors;
}

} // namespace hachure::picture
