#pragma once

#include <hachure/components/gooch.h>
#include <hachure/components/light.h>

#include "ray_cast.h"

/// What Gooch's modes must show, in double precision, written from the paper and docs/gooch.md alone.
namespace hachure::test {

/// A light as components/light.h describes it, in the world.
struct CastLight {
    LightKind kind = LightKind::directional;
    dvec3 place{0.0};             ///< point, spot
    dvec3 towards{0.0, 1.0, 0.0}; ///< unit: against the direction that it shines in
    dvec3 color{1.0};             ///< relative to the strongest light
    double range = 0.0, inner = 0.0, outer = 0.785398;
    bool gaze = false;
};

/// What arrives at a point of one light.
struct Arriving {
    dvec3 l;      ///< unit, towards the light
    double reach; ///< 0 to 1
    dvec3 color;

    [[nodiscard]] double strength() const { return reach * std::max({color.r, color.g, color.b}); }
};

inline Arriving arriving(const CastLight& light, const dvec3& point, const RayCamera& camera) {
    if (light.kind == LightKind::directional) {
        if (!light.gaze) return {light.towards, 1.0, light.color};
        const dvec3 sight = camera.to_eye(point), about = glm::cross(camera.axis(), sight);
        const double sine = glm::length(about);
        const double angle = std::atan2(sine, glm::dot(camera.axis(), sight));
        if (sine < 1e-12) return {light.towards, 1.0, light.color};
        return {glm::angleAxis(angle, about / sine) * light.towards, 1.0, light.color};
    }
    const dvec3 way = light.place - point;
    const double distance = glm::length(way);
    Arriving result{way / distance, 1.0, light.color};
    if (light.range > 0.0) result.reach = std::clamp(1.0 - std::pow(distance / light.range, 4.0), 0.0, 1.0);
    if (light.kind == LightKind::spot) {
        const double cosine = glm::dot(result.l, light.towards), outer = std::cos(light.outer);
        const double inside = std::clamp((cosine - outer) / (std::cos(light.inner) - outer), 0.0, 1.0);
        result.reach *= inside * inside;
    }
    return result;
}

struct GoochTones {
    dvec3 cool, warm;

    /// Equation 3.
    GoochTones(const Gooch& gooch, const dvec3& k_d)
        : cool(dvec3(0.0, 0.0, double(gooch.b)) + double(gooch.alpha) * k_d),
          warm(dvec3(double(gooch.y), double(gooch.y), 0.0) + double(gooch.beta) * k_d) {
        if (gooch.printed_equation) std::swap(cool, warm);
    }
};

inline double phong_term(const Gooch& gooch, const dvec3& n, const dvec3& l, const dvec3& to_eye) {
    const dvec3 mirrored = 2.0 * glm::dot(l, n) * n - l;
    return std::pow(std::max(0.0, glm::dot(mirrored, glm::normalize(to_eye))), double(gooch.shininess));
}

/// Equation 2 with the warm tone on the lit side, or as printed; then the highlights.
inline dvec3 tone_color(const Gooch& gooch, const dvec3& k_d, const dvec3& n, const dvec3& to_eye,
                        const std::vector<Arriving>& lights) {
    double total = 0.0, warmth = 0.0, through = 1.0, shares = 0.0;
    dvec3 shine(0.0);
    for (const Arriving& light : lights) {
        total += light.strength();
        warmth += light.strength() * 0.5 * (1.0 + glm::dot(light.l, n));
        const double phong = double(gooch.highlight) * phong_term(gooch, n, light.l, to_eye);
        shine += phong * light.reach * light.color;
        shares += phong * light.strength();
        through *= 1.0 - phong * light.strength();
    }
    const double weight = warmth / std::max(1.0, total);
    const GoochTones tones(gooch, k_d);
    const dvec3 tone = weight * tones.warm + (1.0 - weight) * tones.cool;
    return shares > 0.0 ? through * tone + (1.0 - through) * shine / shares : tone;
}

/// Section 4.4 with one light, and what a pipeline shows that sets negative colours of lights to 0.
inline dvec3 two_light_color(const Gooch& gooch, const dvec3& k_d, const dvec3& n, const dvec3& l) {
    const GoochTones tones(gooch, k_d);
    dvec3 color = (tones.cool + tones.warm) / 2.0;
    const dvec3 lights[] = {(tones.warm - tones.cool) / 2.0, (tones.cool - tones.warm) / 2.0};
    for (int i = 0; i < 2; ++i) {
        const dvec3 light = gooch.clamp_lights ? glm::max(lights[i], dvec3(0.0)) : lights[i];
        color += std::max(0.0, i == 0 ? glm::dot(l, n) : glm::dot(-l, n)) * light;
    }
    return color;
}

/// Equation 1, and Phong's highlights.
inline dvec3 phong_color(const Gooch& gooch, const dvec3& k_d, const dvec3& n, const dvec3& to_eye,
                         const std::vector<Arriving>& lights) {
    dvec3 color = double(gooch.diffuse) * double(gooch.ambient) * k_d;
    for (const Arriving& light : lights)
        color += light.reach * light.color *
                 (double(gooch.diffuse) * k_d * std::max(0.0, glm::dot(light.l, n)) +
                  double(gooch.highlight) * phong_term(gooch, n, light.l, to_eye));
    return color;
}

/// With one white light that reaches everything.
inline dvec3 gooch_color(const Gooch& gooch, const dvec3& k_d, const dvec3& n, const dvec3& l, const dvec3& to_eye) {
    return tone_color(gooch, k_d, n, to_eye, {{l, 1.0, dvec3(1.0)}});
}

} // namespace hachure::test
