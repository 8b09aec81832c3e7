#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hachure::geometry {

/// A mesh cut into smooth, oriented sheets: every edge has one or two triangles and every vertex one fan of them. It is
/// cut where more than two triangles meet (the flattest pairs stay together), where two disagree about their front, and
/// along hard edges. Triangles with two corners at one place and repeated ones are left out.
struct SurfaceSheets {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::array<std::uint32_t, 3>> triangles; ///< vertices, counter-clockwise
    std::vector<std::uint32_t> face;                     ///< per triangle: its number in the input
    /// Half-edge 3t + k runs from corner k of triangle t to corner k + 1. Per half-edge: the one back on the other
    /// side, or `none` at a border.
    std::vector<std::uint32_t> opposite;
    std::vector<glm::dvec3> positions; ///< per vertex
    /// Per vertex: the first half-edge out of it, counter-clockwise; at a border the one along the border.
    std::vector<std::uint32_t> out;
    std::vector<std::uint32_t> sheet; ///< per vertex: the connected sheet that it is of, counted from 0
    std::uint32_t sheets = 0;
    /// Per triangle of the input: the triangle here that lies on the same places, or `none` when it has no three.
    std::vector<std::uint32_t> triangle_of;

    [[nodiscard]] static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t tail(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
    [[nodiscard]] std::uint32_t head(std::uint32_t h) const { return tail(next(h)); }
    [[nodiscard]] bool at_border(std::uint32_t vertex) const { return opposite[out[vertex]] == none; }
    /// Of the two half-edges of an edge, the one that stands for it.
    [[nodiscard]] bool is_first(std::uint32_t h) const { return opposite[h] == none || h < opposite[h]; }

    /// Calls `visit(half-edge)` for those out of a vertex, counter-clockwise.
    template <class Visit> void each_out(std::uint32_t vertex, Visit&& visit) const {
        std::uint32_t h = out[vertex];
        do {
            visit(h);
            h = opposite[previous(h)];
        } while (h != none && h != out[vertex]);
    }
};

/// Edges are hard where their faces turn by more than `crease_angle` radians and, when there are `normals` (one per
/// vertex, or none), their normals differ at both ends.
[[nodiscard]] SurfaceSheets cut_into_sheets(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                            std::span<const std::uint32_t> indices, double crease_angle);

} // namespace hachure::geometry
