#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace hachure::geometry::reference {

/// A torus around +Y by closed forms.
struct ExactTorus {
    double major, minor;

    struct Place {
        double around, across; ///< radians: about the axis, and from the outer equator towards +Y
    };

    [[nodiscard]] glm::dvec3 outwards(double around) const { return {std::cos(around), 0.0, std::sin(around)}; }
    [[nodiscard]] glm::dvec3 normal(const Place& at) const {
        return std::cos(at.across) * outwards(at.around) + glm::dvec3(0.0, std::sin(at.across), 0.0);
    }
    [[nodiscard]] glm::dvec3 position(const Place& at) const {
        return major * outwards(at.around) + minor * normal(at);
    }
    [[nodiscard]] Place nearest(const glm::dvec3& p) const {
        const double around = std::atan2(p.z, p.x);
        return {around, std::atan2(p.y, std::hypot(p.x, p.z) - major)};
    }
    /// Unit, along the tube's section: the direction in which the normal curvature is 1 / minor.
    [[nodiscard]] glm::dvec3 across(const Place& at) const {
        return -std::sin(at.across) * outwards(at.around) + glm::dvec3(0.0, std::cos(at.across), 0.0);
    }
    [[nodiscard]] glm::dvec3 around(const Place& at) const { return {-std::sin(at.around), 0.0, std::cos(at.around)}; }
    /// Distance from the axis.
    [[nodiscard]] double ring(const Place& at) const { return major + minor * std::cos(at.across); }
    /// Normal curvature along `around`.
    [[nodiscard]] double around_curvature(const Place& at) const { return std::cos(at.across) / ring(at); }

    struct View {
        glm::dvec3 view, along; ///< to the eye, and its unit part in the tangent plane
        double curvature;       ///< radial
        double sine, cosine;    ///< of the angle between normal and view
    };
    [[nodiscard]] View view(const Place& at, const glm::dvec4& eye) const {
        View result{};
        result.view = glm::dvec3(eye) - eye.w * position(at);
        const double u = glm::dot(result.view, across(at)), v = glm::dot(result.view, around(at));
        const double square = u * u + v * v;
        result.along = (u * across(at) + v * around(at)) / std::sqrt(square);
        result.curvature = (u * u / minor + v * v * around_curvature(at)) / square;
        result.sine = std::sqrt(square) / glm::length(result.view);
        result.cosine = glm::dot(result.view, normal(at)) / glm::length(result.view);
        return result;
    }
    /// The place a step further in a tangent direction.
    [[nodiscard]] Place moved(const Place& at, const glm::dvec3& step) const {
        return {at.around + glm::dot(step, around(at)) / ring(at), at.across + glm::dot(step, across(at)) / minor};
    }
    /// The change of radial curvature towards the eye, by differences.
    [[nodiscard]] double radial_derivative(const Place& at, const glm::dvec4& eye) const {
        const double h = 1e-5 * minor;
        const glm::dvec3 along = view(at, eye).along;
        return (view(moved(at, h * along), eye).curvature - view(moved(at, -h * along), eye).curvature) / (2.0 * h);
    }
};

} // namespace hachure::geometry::reference
