#pragma once

#include <hachure/components/metal.h>
#include <hachure/systems/metal/stripe_ramp.h>
#include <hachure/tests/systems/gooch/closed_form.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

/// What metal on a cylinder must be, in double precision, from the intensities of the stripes alone. Shares no code
/// with the shaders or the systems.
namespace hachure::test {

/// Stripes that are counted in `x`: the centre of stripe k lies at k + 1/2, for all whole k.
struct StripePattern {
    std::vector<double> intensities; ///< of a set
    bool mirrored = false;           ///< every other set
    double per_turn = 20.0;          ///< stripes in a turn of the surface
    double light = 1e9;              ///< where the surface faces the light; far away: nowhere
    double white = 1.0;              ///< how white the stripe is there

    [[nodiscard]] double centre(long k) const {
        const auto count = static_cast<long>(intensities.size());
        const long set = k >= 0 ? k / count : -((count - 1 - k) / count), within = k - set * count;
        const double c = intensities[static_cast<std::size_t>(mirrored && set % 2 != 0 ? count - 1 - within : within)];
        const double away = std::abs(std::remainder(static_cast<double>(k) + 0.5 - light, per_turn));
        return c + white * std::clamp(1.5 - away, 0.0, 1.0) * (1.0 - c);
    }
    [[nodiscard]] double at(double x) const {
        const double left = std::floor(x - 0.5), t = x - 0.5 - left;
        return (1.0 - t) * centre(static_cast<long>(left)) + t * centre(static_cast<long>(left) + 1);
    }
    /// The average over the pixel on which x changes by `a` across and by `b` down, by the midpoint rule.
    [[nodiscard]] double average(double x, double a, double b) const {
        const double high = std::max(std::abs(a), std::abs(b)), low = std::min(std::abs(a), std::abs(b));
        const double half = 0.5 * (high + low);
        // So that a step is under 1/40 of a stripe: its error is under 1/40^2 / 24 of the change of slope at a centre.
        const int steps = std::max(64, static_cast<int>(80.0 * half));
        double sum = 0.0, weights = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double offset = half * (2.0 * (i + 0.5) / steps - 1.0);
            const double weight = std::min(low, std::max(half - std::abs(offset), 0.0)) + 1e-12;
            sum += weight * at(x + offset);
            weights += weight;
        }
        return sum / weights;
    }
};

/// A cylinder of radius 1 about the Y axis of its entity, |y| <= half_height.
struct CastCylinder {
    Transform place;
    double half_height = 2.0;

    struct Meeting {
        double angle;  ///< about the axis, from +X towards -Z
        dvec3 normal;  ///< in the world
        double facing; ///< cosine between the normal and the direction to the eye
    };

    [[nodiscard]] std::optional<Meeting> meet(const Ray& ray) const {
        const glm::dmat3 turn = glm::mat3_cast(glm::dquat(place.rotation));
        const double scale = double(place.scale.x);
        const dvec3 o = glm::transpose(turn) * (ray.origin - dvec3(place.translation)) / scale;
        const dvec3 d = glm::transpose(turn) * ray.direction;
        const double a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z, c = o.x * o.x + o.z * o.z - 1.0;
        if (b * b <= a * c) return std::nullopt;
        const dvec3 p = o + (-b - std::sqrt(b * b - a * c)) / a * d;
        if (std::abs(p.y) > half_height) return std::nullopt;
        const dvec3 n(p.x, 0.0, p.z);
        return Meeting{std::atan2(-p.z, p.x), turn * n, -glm::dot(n, glm::normalize(d))};
    }
    /// Where the surface faces the direction `l` of the world.
    [[nodiscard]] double angle_towards(const dvec3& l) const {
        const dvec3 local = glm::transpose(glm::dmat3(glm::mat3_cast(glm::dquat(place.rotation)))) * l;
        return std::atan2(-local.z, local.x);
    }
};

inline std::vector<double> intensities_of(const Metal& metal) {
    std::vector<double> result;
    for (std::uint32_t i = 0; i < metal.count; ++i)
        result.push_back(
            stripe_intensity({.seed = metal.seed, .count = metal.count, .low = metal.low, .high = metal.high}, i));
    return result;
}

} // namespace hachure::test
