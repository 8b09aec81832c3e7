#include "hills.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace hill_walk {
namespace {

using namespace hachure;

constexpr std::uint32_t cells = 200; // a side: one is about 13 cm

/// The gradient at a point of the lattice: any direction, always the same (a counter-based random number).
glm::dvec2 gradient(std::int64_t x, std::int64_t z) {
    std::uint64_t bits =
        static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4fu;
    bits = (bits ^ (bits >> 31)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 29)) * 0x94d049bb133111ebu;
    const double angle = static_cast<double>(bits >> 40) / (1 << 24) * glm::two_pi<double>();
    return {std::cos(angle), std::sin(angle)};
}

double fade(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

/// Gradient noise (Perlin 2002), within about -0.7 and 0.7; its second derivatives are continuous.
double noise(glm::dvec2 p) {
    const glm::dvec2 cell = glm::floor(p), at = p - cell;
    const auto corner = [&](int x, int z) {
        const auto i = static_cast<std::int64_t>(cell.x) + x, j = static_cast<std::int64_t>(cell.y) + z;
        return glm::dot(gradient(i, j), at - glm::dvec2(x, z));
    };
    const double u = fade(at.x), v = fade(at.y);
    return glm::mix(glm::mix(corner(0, 0), corner(1, 0), u), glm::mix(corner(0, 1), corner(1, 1), u), v);
}

/// |n| with a rounded crease.
double creased(double n) { return std::sqrt(n * n + 0.0025); }

/// From 1 inland to 0 at the shore, with no slope at either end.
double inland(double r) { return 1.0 - glm::smoothstep(0.55, 0.95, r / hills_radius); }

/// How much of the hills is left along the path.
double beside_path(double r) {
    const double d = (r - path_radius) / 1.5;
    return 1.0 - 0.55 * std::exp(-d * d);
}

/// A square onto a disc of the same cells, area by area (Shirley and Chiu 1997), u and v in [-1, 1].
glm::dvec2 on_disc(double u, double v) {
    if (u == 0.0 && v == 0.0) return {0.0, 0.0};
    const double quarter = glm::quarter_pi<double>();
    if (std::abs(u) > std::abs(v)) return u * glm::dvec2(std::cos(quarter * v / u), std::sin(quarter * v / u));
    return v * glm::dvec2(std::sin(quarter * u / v), std::cos(quarter * u / v));
}

} // namespace

double ground_height(double x, double z) {
    const glm::dvec2 p(x, z);
    // Ridges run where one noise is zero, valleys where another is.
    const double ridges = 0.55 - creased(noise(p / 5.2 + 17.3));
    const double valleys = creased(noise(p / 4.1 - 8.7)) - 0.3;
    const double r = glm::length(p);
    return inland(r) * beside_path(r) * (3.4 * ridges + 2.6 * valleys);
}

glm::vec3 ground_normal(double x, double z) {
    constexpr double h = 1e-4;
    return glm::vec3(glm::normalize(glm::dvec3(ground_height(x - h, z) - ground_height(x + h, z), 2.0 * h,
                                               ground_height(x, z - h) - ground_height(x, z + h))));
}

assets::Model hills_model() {
    assets::Primitive ground;
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const glm::dvec2 p = hills_radius * on_disc(2.0 * i / cells - 1.0, 2.0 * j / cells - 1.0);
            ground.positions.emplace_back(p.x, ground_height(p.x, p.y), p.y);
            ground.normals.push_back(ground_normal(p.x, p.y));
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
            ground.indices.insert(ground.indices.end(), {a, c, b, b, c, d});
        }
    ground.material = 0;
    assets::Model model;
    model.materials.push_back({.name = "ground", .base_color = {0.8f, 0.78f, 0.66f, 1.0f}});
    model.meshes.push_back({"hills", {std::move(ground)}, {}});
    model.nodes.push_back({.name = "hills", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

} // namespace hill_walk
