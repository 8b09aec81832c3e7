#pragma once

#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/tests/support/drawn_scene.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace hachure::test {

/// The relief z(x, y) = height * h(r), -extent <= x, y <= extent, as a grid of `cells` x `cells` squares, with the
/// normals of the function at its vertices. `slope` is h'. `bump(x, y)` is added, if it is given, with its gradient.
struct Bump {
    double z = 0.0;
    glm::dvec2 gradient{0.0};
};
template <class Height, class Slope, class Bumps>
SurfaceMesh ripple_mesh(int cells, double extent, double height, const Height& h, const Slope& slope,
                        const Bumps& bump) {
    geometry::Shape shape;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const glm::dvec2 p(extent * (2.0 * i / cells - 1.0), extent * (2.0 * j / cells - 1.0));
            const double r = std::max(glm::length(p), 1e-9);
            const Bump more = bump(p);
            const glm::dvec2 gradient = height * slope(r) * p / r + more.gradient;
            shape.positions.emplace_back(p.x, p.y, height * h(r) + more.z);
            shape.normals.emplace_back(glm::normalize(glm::dvec3(-gradient, 1.0)));
        }
    const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
                shape.indices.push_back(vertex(i + x, j + y));
    return surface_mesh(shape);
}

template <class Height, class Slope>
SurfaceMesh ripple_mesh(int cells, double extent, double height, const Height& h, const Slope& slope) {
    return ripple_mesh(cells, extent, height, h, slope, [](glm::dvec2) { return Bump{}; });
}

} // namespace hachure::test
