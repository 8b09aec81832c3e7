#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

inline constexpr std::uint32_t no_face = 0xffffffffu;

/// Properties of an edge, to be combined.
enum EdgeFlag : std::uint32_t {
    edge_border = 1u,              ///< one triangle only: `face1` is `no_face`
    edge_non_manifold = 2u,        ///< three triangles or more meet here
    edge_orientation_mismatch = 4u ///< both triangles run along it in the same direction: their sides disagree
};

/// An edge between vertices at two different places. The layout is that of five 32-bit words, fit for a GPU buffer.
struct Edge {
    std::uint32_t v0, v1;       ///< vertices of the input (the first at their place); `face0` runs from v0 to v1
    std::uint32_t face0, face1; ///< triangles of the input (position in `indices` / 3), face0 < face1 or `no_face`
    std::uint32_t flags;        ///< EdgeFlag
};

/// Every edge of a triangle mesh with the triangles on its sides, in a fixed order.
struct EdgeTable {
    std::vector<Edge> edges;
    std::uint32_t dropped_degenerate = 0; ///< triangles with two corners at one place
    std::uint32_t dropped_duplicate = 0;  ///< triangles with the same three places as an earlier one
    std::uint32_t bridged_slivers = 0;    ///< triangles without an area that were looked through (see below)
};

/// Builds the table. Vertices at bit-equal positions are one, so that seams are no borders.
///
/// - Triangles with two corners at one place, and those on the three places of an earlier one, are left out first; they
///   would make false borders and false silhouettes. So two triangles back to back are one sheet, and a leaf modelled
///   from both sides has a border.
/// - Where k > 2 triangles meet there are k - 1 entries, all flagged: the first triangle with each of the others. The
///   edge is a silhouette exactly when one of its entries is. But where two triangles are left besides such sheets,
///   there is one entry, of those two: the sheets are fins, as decimation leaves them, and end in borders of their own.
/// - A triangle with three places and no area (height under 1e-6 of its longest edge) has no side that it faces. Its
///   neighbours are joined through it: its two short edges get the triangle behind its long edge, which itself is left
///   out. So it makes neither a gap nor a line.
[[nodiscard]] EdgeTable build_edge_table(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// The plane of every triangle: unit normal in xyz, and w such that dot(xyz, p) + w is the signed distance of p. A
/// triangle without an area has four zeros. `planes` has one element per triangle. No allocation.
void face_planes(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                 std::span<glm::vec4> planes);

/// The same on several threads.
void face_planes_in_parallel(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                             std::span<glm::vec4> planes);

} // namespace hachure::geometry
