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

/// The same for normals that are to be smooth again on a deformed mesh: vertices at one place are one where their
/// normals (unit, one per vertex) are within half a degree, so that hard edges stay hard.
[[nodiscard]] std::vector<std::uint32_t> weld_normals(std::span<const glm::vec3> positions,
                                                      std::span<const glm::vec3> normals);

} // namespace hachure::geometry
