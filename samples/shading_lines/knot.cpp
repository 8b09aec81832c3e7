#include "knot.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace shading_lines {
namespace {

using namespace hachure;

constexpr std::uint32_t along = 480, across = 64;

/// Where the tube's middle is, `t` once round in [0, 1].
glm::dvec3 middle(double t) {
    const double a = glm::two_pi<double>() * t;
    return {std::sin(a) + 2.0 * std::sin(2.0 * a), std::cos(a) - 2.0 * std::cos(2.0 * a), -std::sin(3.0 * a)};
}

/// A point of the surface, `s` once round the tube.
glm::dvec3 surface(double t, double s) {
    const glm::dvec3 forward = glm::normalize(middle(t + 1e-4) - middle(t - 1e-4));
    const glm::dvec3 bend = middle(t + 1e-3) - 2.0 * middle(t) + middle(t - 1e-3);
    const glm::dvec3 side = glm::normalize(bend - glm::dot(bend, forward) * forward);
    const glm::dvec3 up = glm::cross(forward, side);
    const double turn = glm::two_pi<double>() * s;
    const double radius = 0.5 + 0.1 * std::sin(9.0 * glm::two_pi<double>() * t) +
                          0.035 * std::cos(6.0 * turn + 12.0 * glm::two_pi<double>() * t);
    return middle(t) + radius * (std::cos(turn) * side + std::sin(turn) * up);
}

glm::vec3 normal(double t, double s) {
    const double h = 1e-4;
    const glm::dvec3 du = surface(t + h, s) - surface(t - h, s), dv = surface(t, s + h) - surface(t, s - h);
    return glm::vec3(glm::normalize(glm::cross(dv, du)));
}

} // namespace

assets::Model knot_model() {
    assets::Primitive primitive;
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const double t = double(i) / along, s = double(j) / across;
            primitive.positions.push_back(glm::vec3(surface(t, s)));
            primitive.normals.push_back(normal(t, s));
            const std::uint32_t next_i = (i + 1) % along, next_j = (j + 1) % across;
            const std::uint32_t a = i * across + j, b = next_i * across + j, c = next_i * across + next_j,
                                d = i * across + next_j;
            primitive.indices.insert(primitive.indices.end(), {a, c, b, a, d, c});
        }
    primitive.material = 0;
    assets::Model model;
    model.materials.push_back({.name = "clay", .base_color = {0.62f, 0.55f, 0.47f, 1.0f}});
    model.meshes.push_back({"knot", {std::move(primitive)}, {}});
    model.nodes.push_back({.name = "knot", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

} // namespace shading_lines
