#pragma once

#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/sheet_curvature.h>
#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// How many sets of stripes there should be per metre across the lines of the field, per vertex: near `sets` per half
/// turn of the normal or per size of the object, whichever is more, up to 5 times as many on sheets with singularities
/// (the square root of their number), and so graded that stripes can follow the lines everywhere: with the direction X
/// and the rate r, the curl of r X is to vanish (Knoeppel et al. 2015, section 5.1, in the logarithm of r, so that it
/// stays positive).
[[nodiscard]] std::vector<double> stripe_rates(const SurfaceSheets& sheets, const SheetMetric& metric,
                                               const SheetCurvature& curvature, const DirectionField& field,
                                               std::span<const std::uint32_t> order, double sets);

} // namespace hachure::geometry
