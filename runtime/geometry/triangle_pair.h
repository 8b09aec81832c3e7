#pragma once

#include <hachure/runtime/geometry/surface_segment.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace hachure::geometry {

/// A triangle as its intersections with others need it.
struct PlacedTriangle {
    std::array<glm::vec3, 3> position;
    std::array<std::uint32_t, 3> place; ///< of each corner: equal exactly where positions are; over both meshes
    std::array<std::uint64_t, 3> edge;  ///< an id of the edge from each corner to the next, below 2^31
    std::uint32_t face;
};

/// The line along which two triangles pass through each other, see intersect_meshes.h for what touching ones have. The
/// ids of its ends are those of an edge and a face, or of the place that both share.
[[nodiscard]] std::optional<SurfaceSegment> intersection(const PlacedTriangle& a, const PlacedTriangle& b);

} // namespace hachure::geometry
