#include "dunes.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace sun_walk {
namespace {

using namespace hachure;

constexpr std::uint32_t rings = 60, sides = 180;

/// A round hill.
double bump(const glm::dvec2& p, const glm::dvec2& at, double radius, double height) {
    const glm::dvec2 off = (p - at) / radius;
    return height * std::exp(-glm::dot(off, off));
}

glm::vec3 dune_normal(double x, double z) {
    constexpr double h = 1e-4;
    return glm::vec3(glm::normalize(glm::dvec3(dune_height(x - h, z) - dune_height(x + h, z), 2.0 * h,
                                               dune_height(x, z - h) - dune_height(x, z + h))));
}

void add_vertex(assets::Primitive& ground, double x, double z) {
    ground.positions.emplace_back(x, dune_height(x, z), z);
    ground.normals.push_back(dune_normal(x, z));
}

} // namespace

double dune_height(double x, double z) {
    const glm::dvec2 p(x, z);
    const double dunes = bump(p, {0.0, 0.0}, 1.2, 0.9) + bump(p, {-4.0, -1.6}, 1.3, 1.1) +
                         bump(p, {3.6, -2.6}, 1.5, 1.4) + bump(p, {2.6, 3.4}, 1.0, 0.5);
    return dunes * (1.0 - glm::smoothstep(0.75, 1.0, glm::length(p) / dunes_radius));
}

assets::Model dunes_model() {
    assets::Primitive ground;
    add_vertex(ground, 0.0, 0.0);
    for (std::uint32_t ring = 1; ring <= rings; ++ring)
        for (std::uint32_t side = 0; side < sides; ++side) {
            const double r = dunes_radius * ring / rings, angle = glm::two_pi<double>() * side / sides;
            add_vertex(ground, r * std::cos(angle), r * std::sin(angle));
        }
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t next = (side + 1) % sides;
        ground.indices.insert(ground.indices.end(), {0, 1 + next, 1 + side});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t a = 1 + ring * sides + side, b = 1 + ring * sides + next, c = a + sides, d = b + sides;
            ground.indices.insert(ground.indices.end(), {a, b, c, b, d, c});
        }
    }
    ground.material = 0;
    assets::Model model;
    model.materials.push_back({.name = "ground", .base_color = {0.85f, 0.8f, 0.68f, 1.0f}});
    model.meshes.push_back({"dunes", {std::move(ground)}, {}});
    model.nodes.push_back({.name = "dunes", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

} // namespace sun_walk
