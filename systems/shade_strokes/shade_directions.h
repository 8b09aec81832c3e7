#pragma once

#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace hachure {

/// Where strokes run and how wide they may be, per vertex of sheets.
struct ShadeDirections {
    std::vector<glm::vec3> along; ///< unit tangent of the second principal direction, of either sign
    std::vector<float> curvature; ///< |first principal curvature|, smoothed over a few edges, 1/metre
};

/// The second principal directions where there are some, and a smooth field in between: at umbilics and on flat parts
/// directions are those of their surroundings and, where nothing decides, along the object's Y axis. So rounding moves
/// them little. `curvatures` (k1, k2 with |k1| >= |k2|) and `directions` (unit, of k1) are per vertex of the input that
/// `indices` refer to; or empty: then they are computed, from the triangles around each vertex and the
/// `normals` (unit, one per vertex of the input, or none).
[[nodiscard]] ShadeDirections
shade_directions(const geometry::SurfaceSheets& sheets, const geometry::SheetMetric& metric,
                 std::span<const std::uint32_t> indices, std::span<const glm::vec3> normals,
                 std::span<const glm::vec2> curvatures, std::span<const glm::vec3> directions);

} // namespace hachure
