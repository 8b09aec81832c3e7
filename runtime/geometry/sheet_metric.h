#pragma once

#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec3.hpp>

#include <complex>
#include <cstdint>
#include <vector>

namespace hachure::geometry {

/// Lengths, angles and frames on sheets. A tangent vector at a vertex is a complex number in the vertex's frame, whose
/// angles run over the triangles around it, stretched to a full turn inside the sheet (Knoeppel et al. 2013, section
/// 3). All numbers are finite, whatever the triangles.
struct SheetMetric {
    using Complex = std::complex<double>;

    std::vector<double> length;     ///< per half-edge
    std::vector<double> angle;      ///< per corner: inside the triangle, radians
    std::vector<double> area;       ///< per triangle
    std::vector<double> tail_angle; ///< per half-edge: its direction in the frame of its tail
    std::vector<double> head_angle; ///< per half-edge: the direction back along it in the frame of its head
    std::vector<double> weight;     ///< per half-edge: that of its edge in a Laplacian (cotangents, kept positive)
    std::vector<double> mass;       ///< per vertex: a third of the triangles around it; positive
    std::vector<double> turn;       ///< per vertex: the sum of angles around it, radians, before any stretching
    /// Per vertex: 1 at sharp tips, as of cones, which have no direction: their edges weigh almost nothing. No two are
    /// neighbours.
    std::vector<std::uint8_t> tip;
    std::vector<double> excess;     ///< per triangle: how far its stretched angles exceed half a turn
    std::vector<glm::dvec3> normal; ///< per vertex, unit
    std::vector<glm::dvec3> axis;   ///< per vertex: the unit tangent that is 1 in its frame
    std::vector<double> sheet_size; ///< per sheet: the diagonal of its bounds; positive
    glm::dvec3 centre{0.0};         ///< of all bounds
    double size = 1.0;              ///< the diagonal of all bounds; positive

    explicit SheetMetric(const SurfaceSheets& sheets);

    [[nodiscard]] bool has_tip(const SurfaceSheets& sheets, std::uint32_t triangle) const;
    /// By which angle a vector turns that is carried along a half-edge from the frame of its tail to that of its head.
    [[nodiscard]] double transport(std::uint32_t h) const;
    /// A tangent vector in space as a number in the frame of a vertex, and back.
    [[nodiscard]] Complex to_frame(std::uint32_t vertex, const glm::dvec3& v) const;
    [[nodiscard]] glm::dvec3 to_space(std::uint32_t vertex, Complex z) const;
};

} // namespace hachure::geometry
