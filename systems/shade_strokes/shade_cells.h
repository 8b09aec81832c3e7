#pragma once

#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// A surface divided into cells of about one size, whatever its triangles: small ones are gathered, large ones divided.
/// It is the coarser mesh for the light that the paper leaves to the future (section 2.3.5). The parts of triangles
/// that cells are made of are called atoms: a triangle has parts^2 alike ones.
struct ShadeCells {
    std::vector<std::uint16_t> parts;      ///< per triangle of the sheets: into how many parts its edges are divided
    std::vector<std::uint32_t> first_atom; ///< per triangle, one more at the end
    std::vector<std::uint32_t> cell_of_atom;
    std::vector<float> area;                 ///< per cell
    std::vector<std::uint32_t> first_member; ///< per cell, one more at the end: into `members`
    std::vector<std::uint32_t> members;      ///< atoms
    std::vector<float> share;                ///< per member: the area of the cell's members up to and with it

    [[nodiscard]] std::size_t count() const { return area.size(); }
    [[nodiscard]] std::uint32_t atom_at(std::uint32_t triangle, const glm::dvec3& weight) const;
    [[nodiscard]] std::uint32_t cell_at(std::uint32_t triangle, const glm::dvec3& weight) const {
        return cell_of_atom[atom_at(triangle, weight)];
    }
    [[nodiscard]] std::uint32_t triangle_of(std::uint32_t atom) const;
    /// The corners of an atom, as weights of its triangle's.
    [[nodiscard]] std::array<glm::dvec3, 3> atom_corners(std::uint32_t triangle, std::uint32_t atom) const;
    /// A point of a cell for three numbers in [0, 1), evenly over its area: triangle and weights.
    struct Point {
        std::uint32_t triangle;
        glm::dvec3 weight;
    };
    [[nodiscard]] Point point_in(std::uint32_t cell, double which, double a, double b) const;
};

/// About `wanted` cells, connected and compact, each on one sheet and where it can with normals within about 40
/// degrees. Fewer when there is little to divide: at most 128 x 128 parts of a triangle are told apart.
[[nodiscard]] ShadeCells make_shade_cells(const geometry::SurfaceSheets& sheets, std::span<const double> areas,
                                          std::uint32_t wanted);

} // namespace hachure
