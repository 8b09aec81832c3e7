#pragma once

#include <hachure/runtime/geometry/edges.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>

namespace hachure::geometry {

/// An end that no other segment can have.
inline constexpr std::uint64_t free_end = std::numeric_limits<std::uint64_t>::max();

/// A straight piece of a line that crosses a triangle. Where lines go on over an edge, both pieces end at the same
/// place, bit for bit, with the same id.
struct SurfaceSegment {
    glm::vec3 start, end;                         ///< in the mesh's space
    float start_weight = 1.0f, end_weight = 1.0f; ///< how strongly it is drawn there, 0 (not at all) to 1
    std::uint32_t face = no_face;                 ///< the triangle that it lies in
    std::uint32_t other_face = no_face;           ///< of an intersection: the other triangle that it lies in
    std::uint64_t start_id = free_end, end_id = free_end;

    friend bool operator==(const SurfaceSegment&, const SurfaceSegment&) = default;
};

/// The id of an end on the edge between two vertices (those that stand for their places).
[[nodiscard]] constexpr std::uint64_t end_on_edge(std::uint32_t low, std::uint32_t high) {
    return (static_cast<std::uint64_t>(low) << 32) | high;
}

/// The id of an end at a vertex (the one that stands for its place).
[[nodiscard]] constexpr std::uint64_t end_at_vertex(std::uint32_t vertex) { return end_on_edge(vertex, vertex); }

} // namespace hachure::geometry
