#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/toon.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/view.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

/// What a sphere must look like under Toon, in double precision by ray casting. Shares no code with the shaders.
namespace hachure::test {

using glm::dvec3;

struct ToonLight {
    Light light;
    Transform place;
};

/// What a ray through a pixel's centre, or any place of the picture, meets.
struct ToonPoint {
    bool hit = false;
    dvec3 position{0.0}, normal{0.0}, to_eye{0.0};
};

struct ToonScene {
    Canvas canvas;
    Camera camera;
    Transform eye; ///< of the camera
    std::vector<ToonLight> lights;
    dvec3 color{0.8, 0.5, 0.3};
    double radius = 1.0; ///< of the sphere, at the origin

    [[nodiscard]] dvec3 axis(int i) const {
        dvec3 unit(0.0);
        unit[i] = 1.0;
        return glm::dquat(eye.rotation) * unit;
    }

    /// Columns and rows in pixels from the upper left corner; pixel centres are at halves.
    [[nodiscard]] ToonPoint cast(double column, double row) const {
        const double x = (2.0 * column / canvas.width - 1.0) * canvas.width / canvas.height;
        const double y = 1.0 - 2.0 * row / canvas.height;
        dvec3 from(eye.translation), towards;
        if (camera.projection == Projection::orthographic) {
            from += double(camera.ymag) * (x * axis(0) + y * axis(1));
            towards = -axis(2);
        } else {
            towards = glm::normalize(std::tan(0.5 * double(camera.yfov)) * (x * axis(0) + y * axis(1)) - axis(2));
        }
        const double half = glm::dot(from, towards), rest = half * half - glm::dot(from, from) + radius * radius;
        if (rest < 0.0) return {};
        const dvec3 position = from + (-half - std::sqrt(rest)) * towards;
        return {true, position, position / radius, -towards};
    }

    [[nodiscard]] double strongest() const {
        double most = 0.0;
        for (const ToonLight& light : lights) most = std::max(most, strength(light));
        return most;
    }
    static double strength(const ToonLight& light) {
        return double(std::max({light.light.color.r, light.light.color.g, light.light.color.b})) *
               double(light.light.intensity);
    }

    /// Unit, from a place to a light; and how much of the light comes there.
    [[nodiscard]] static dvec3 towards(const ToonLight& light, const dvec3& place) {
        const dvec3 back = glm::dquat(light.place.rotation) * dvec3(0, 0, 1);
        return light.light.kind == LightKind::directional ? back
                                                          : glm::normalize(dvec3(light.place.translation) - place);
    }
    [[nodiscard]] static double reach(const ToonLight& light, const dvec3& place) {
        if (light.light.kind == LightKind::directional) return 1.0;
        const double distance = glm::distance(dvec3(light.place.translation), place), range = light.light.range;
        double result = range > 0.0 ? std::max(0.0, 1.0 - std::pow(distance / range, 4.0)) : 1.0;
        if (light.light.kind == LightKind::spot) {
            const dvec3 ahead = glm::dquat(light.place.rotation) * dvec3(0, 0, -1);
            const double inner = std::cos(double(light.light.inner_cone)),
                         outer = std::cos(double(light.light.outer_cone));
            const double cone =
                std::clamp((glm::dot(ahead, -towards(light, place)) - outer) / (inner - outer), 0.0, 1.0);
            result *= cone * cone;
        }
        return result;
    }

    [[nodiscard]] double tone(const ToonPoint& at, double wrap) const {
        double sum = 0.0;
        for (const ToonLight& light : lights)
            sum += strength(light) / strongest() * reach(light, at.position) *
                   std::max(0.0, (glm::dot(at.normal, towards(light, at.position)) + wrap) / (1.0 + wrap));
        return sum;
    }

    [[nodiscard]] dvec3 light_color(const ToonPoint& at, double wrap) const {
        dvec3 sum(0.05);
        for (const ToonLight& light : lights)
            sum += dvec3(light.light.color) * double(light.light.intensity) / strongest() * reach(light, at.position) *
                   std::max(0.0, (glm::dot(at.normal, towards(light, at.position)) + wrap) / (1.0 + wrap));
        return sum / std::max({sum.x, sum.y, sum.z});
    }
};

/// The mean over [low, high] of a function that is linear between the given places, which are in order.
inline double mean_of_pieces(double low, double high, const std::vector<double>& breaks,
                             const std::function<double(double)>& f) {
    std::vector<double> places{low};
    for (const double place : breaks)
        if (place > low && place < high) places.push_back(place);
    places.push_back(high);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        sum += 0.5 * (f(places[i]) + f(places[i + 1])) * (places[i + 1] - places[i]);
    return sum / (high - low);
}

/// How much of a pixel whose values spread over `width` around `value` lies above an edge of this softness.
inline double part_above(double value, double edge, double width, double softness) {
    if (softness <= 0.0) return std::clamp((value + 0.5 * width - edge) / width, 0.0, 1.0);
    return mean_of_pieces(value - 0.5 * width, value + 0.5 * width, {edge - 0.5 * softness, edge + 0.5 * softness},
                          [&](double t) { return std::clamp((t - edge) / softness + 0.5, 0.0, 1.0); });
}

/// The colour of tone `number` of all, before the material's.
inline dvec3 tone_color(const Toon& toon, int number) {
    if (toon.bands == 1) return dvec3(toon.light);
    const double part = double(number) / (toon.bands - 1);
    dvec3 color;
    for (int c = 0; c < 3; ++c)
        color[c] = std::pow(double(toon.shade[c]), 1.0 - part) * std::pow(double(toon.light[c]), part);
    return color;
}

/// All bands, at the given detail.
inline dvec3 banded(const Toon& toon, double tone, double width, double detail) {
    const double apart = std::clamp(2.0 * detail - 1.0, 0.0, 1.0);
    std::vector<double> above{1.0};
    const double dark = toon.dark_edge, light = toon.light_edge, middle = 0.5 * (dark + light);
    for (int i = 1; i < toon.bands; ++i) {
        const double edge = toon.bands == 2 ? middle : dark + (light - dark) * (i - 1) / (toon.bands - 2);
        above.push_back(part_above(tone, middle + (edge - middle) * apart, width, toon.softness));
    }
    above.push_back(0.0);
    dvec3 sum(0.0);
    for (int i = 0; i < toon.bands; ++i)
        sum += (above[std::size_t(i)] - above[std::size_t(i) + 1]) * tone_color(toon, i);
    const double fade = std::min(1.0, 2.0 * detail);
    return fade * sum + (1.0 - fade) * tone_color(toon, toon.bands - 1);
}

inline double linear_of_srgb(int byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// The mean of a row of an 8-bit RGB picture over a stretch of tones.
inline dvec3 ramp_row_mean(const assets::Image& ramp, int row, double low, double high) {
    dvec3 sum(0.0);
    for (int column = 0; column < ramp.width; ++column) {
        const double from = column == 0 ? -1e9 : double(column) / ramp.width;
        const double to = column + 1 == ramp.width ? 1e9 : double(column + 1) / ramp.width;
        const double part = std::max(0.0, std::min(high, to) - std::max(low, from)) / (high - low);
        for (int c = 0; c < 3; ++c) sum[c] += part * linear_of_srgb(ramp.u8()[3 * (row * ramp.width + column) + c]);
    }
    return sum;
}

inline dvec3 ramped(const Toon& toon, const assets::Image& ramp, double tone, double width, double detail) {
    const double half = 0.5 * std::max({width, double(toon.softness), 1e-3});
    const double y = std::clamp(detail * ramp.height - 0.5, 0.0, ramp.height - 1.0); // from the bottom
    const int below = static_cast<int>(y), above = std::min(below + 1, ramp.height - 1);
    return (1.0 - (y - below)) * ramp_row_mean(ramp, ramp.height - 1 - below, tone - half, tone + half) +
           (y - below) * ramp_row_mean(ramp, ramp.height - 1 - above, tone - half, tone + half);
}

/// D of Barla et al. 2006.
inline double toon_detail(const ToonScene& scene, const Toon& toon, const ToonPoint& at) {
    const auto falling = [&](double z) {
        return 1.0 - std::log(z / double(toon.detail_distance)) / std::log(double(toon.detail_ratio));
    };
    const double depth = glm::dot(dvec3(scene.eye.translation) - at.position, scene.axis(2));
    const bool flat = scene.camera.projection == Projection::orthographic;
    double detail = 1.0;
    switch (toon.detail) {
    case ToonDetail::none:
        break;
    case ToonDetail::depth:
        detail = falling(flat ? depth : glm::distance(dvec3(scene.eye.translation), at.position));
        break;
    case ToonDetail::depth_of_field:
        detail = 1.0 - std::abs(std::log(depth / double(toon.detail_distance))) / std::log(double(toon.detail_ratio));
        break;
    case ToonDetail::focus:
        detail = falling(glm::distance(dvec3(toon.focus_point), at.position));
        break;
    case ToonDetail::orientation:
        detail = std::pow(std::abs(glm::dot(at.normal, at.to_eye)), double(toon.detail_power));
        break;
    case ToonDetail::highlight: {
        const ToonLight* first = &scene.lights[0];
        for (const ToonLight& light : scene.lights)
            if (ToonScene::strength(light) > ToonScene::strength(*first)) first = &light;
        const dvec3 l = ToonScene::towards(*first, at.position);
        const dvec3 mirrored = 2.0 * glm::dot(at.normal, l) * at.normal - l;
        detail = std::pow(std::max(0.0, glm::dot(at.to_eye, mirrored)), double(toon.detail_power));
        break;
    }
    }
    return std::clamp(detail, 0.0, 1.0);
}

} // namespace hachure::test
