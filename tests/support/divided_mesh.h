#pragma once

#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/geometric.hpp>
#include <meshoptimizer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

// One surface as several meshes.
namespace hachure::test {

/// Every triangle cut into four, `times` times over, where it lies: the same surface.
inline geometry::Shape subdivided(geometry::Shape shape, int times) {
    for (int n = 0; n < times; ++n) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.positions.size()));
            if (is_new) {
                shape.positions.push_back(0.5f * (shape.positions[a] + shape.positions[b]));
                shape.normals.push_back(glm::normalize(shape.normals[a] + shape.normals[b]));
            }
            return found->second;
        };
        std::vector<std::uint32_t> indices;
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const std::uint32_t a = shape.indices[i], b = shape.indices[i + 1], c = shape.indices[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            indices.insert(indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        shape.indices = std::move(indices);
    }
    return shape;
}

/// The surface with about `triangles` triangles, and their own normals; as it is when it has no more than that.
inline geometry::Shape decimated(const geometry::Shape& fine, std::size_t triangles) {
    if (3 * triangles >= fine.indices.size()) return fine;
    std::vector<std::uint32_t> indices(fine.indices.size());
    indices.resize(meshopt_simplify(indices.data(), fine.indices.data(), fine.indices.size(), &fine.positions[0].x,
                                    fine.positions.size(), sizeof(glm::vec3), 3 * triangles, 0.1f));
    std::vector<std::uint32_t> place(fine.positions.size(), 0);
    std::vector<bool> is_used(fine.positions.size(), false);
    geometry::Shape shape;
    for (const std::uint32_t i : indices) {
        if (!is_used[i]) {
            is_used[i] = true;
            place[i] = static_cast<std::uint32_t>(shape.positions.size());
            shape.positions.push_back(fine.positions[i]);
        }
        shape.indices.push_back(place[i]);
    }
    shape.normals = geometry::vertex_normals(shape.positions, shape.indices).normals;
    return shape;
}

} // namespace hachure::test
