#pragma once

#include <hachure/runtime/geometry/sheet_curvature.h>
#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Per vertex of sheets: the mean of the normals that are drawn there (`normals`, one per vertex of the input, or
/// none), unit. Without them, those of the metric.
[[nodiscard]] std::vector<glm::dvec3> sheet_normals(const SurfaceSheets& sheets, const SheetMetric& metric,
                                                    std::span<const glm::vec3> normals,
                                                    std::span<const std::uint32_t> indices);

/// Normals without the bumps of the surface: an implicit step of the heat equation to the length that curvature is
/// smoothed to, less where a surface bends by much over that length, so that its bends stay. Unit. On cylinders nothing
/// changes.
[[nodiscard]] std::vector<glm::dvec3> smooth_sheet_normals(const SurfaceSheets& sheets, const SheetMetric& metric,
                                                           const SheetCurvature& curvature,
                                                           const std::vector<glm::dvec3>& normals,
                                                           std::span<const std::uint32_t> order, double detail);

} // namespace hachure::geometry
