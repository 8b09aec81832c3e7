#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace hachure::geometry {

/// What a triangle mesh is made of and what is wrong with it. Vertices at bit-equal positions count as one. Edges,
/// holes, components and orientation leave out degenerate and duplicate triangles.
struct MeshHealth {
    std::uint32_t triangles = 0;             ///< all that the mesh has
    std::uint32_t vertices = 0;              ///< places, isolated ones included
    std::uint32_t isolated_vertices = 0;     ///< places that no triangle uses
    std::uint32_t degenerate_triangles = 0;  ///< two corners at one place
    std::uint32_t sliver_triangles = 0;      ///< three places, and a height under 1e-6 of the longest edge
    std::uint32_t duplicate_triangles = 0;   ///< the same three places and winding as an earlier one
    std::uint32_t opposed_triangles = 0;     ///< the same three places as an earlier one, and the other winding
    std::uint32_t boundary_edges = 0;        ///< with one triangle
    std::uint32_t holes = 0;                 ///< loops of boundary edges; those that touch at a vertex are one
    std::uint32_t non_manifold_edges = 0;    ///< with three triangles or more
    std::uint32_t non_manifold_vertices = 0; ///< whose triangles are not all connected through edges at the vertex
    std::uint32_t mismatched_edges = 0;      ///< with two triangles that disagree which side is the front
    std::uint32_t components = 0;            ///< sets of triangles connected through vertices
    /// Triangles to turn over so that every piece agrees with its majority. A piece is connected through edges that
    /// have two triangles.
    std::uint32_t flipped_triangles = 0;
    std::uint32_t non_orientable_pieces = 0; ///< no turning over makes their sides agree, like a Moebius strip
    std::uint32_t inside_out_pieces = 0;     ///< closed and consistent, with a negative volume

    /// Closed, oriented outwards, and a surface around every vertex.
    [[nodiscard]] bool watertight() const {
        return triangles > 0 && boundary_edges == 0 && non_manifold_edges == 0 && non_manifold_vertices == 0 &&
               mismatched_edges == 0 && inside_out_pieces == 0;
    }
};

[[nodiscard]] MeshHealth inspect(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

} // namespace hachure::geometry
