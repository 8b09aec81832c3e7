#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Concave polygons with more corners than this are cut like convex ones, to bound the time that a file can cost.
inline constexpr std::size_t max_concave_corners = 4096;

/// Cuts a polygon into `corners.size() - 2` triangles with its winding and appends three positions in `corners` for
/// each to `triangles`. Convex polygons become a fan around the first corner. Concave ones are cut by their ears in the
/// plane that fits them best (Newell's normal). A polygon that crosses itself still gives the full count, overlapping.
/// Fewer than three corners give nothing. Returns false when the polygon is concave and beyond the limit above.
bool triangulate_polygon(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles);

} // namespace hachure::geometry
