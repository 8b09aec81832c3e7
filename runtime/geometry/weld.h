#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Finds the vertices that lie at one place: files repeat a vertex along seams of normals or texture coordinates, while
/// the surface is connected there. Returns for every vertex the first vertex with the same position, so that
/// `weld[i] <= i` and `weld[weld[i]] == weld[i]`. Positions are the same when their bits are; -0 equals +0. They must
/// be finite.
[[nodiscard]] std::vector<std::uint32_t> weld_positions(std::span<const glm::vec3> positions);

} // namespace hachure::geometry
