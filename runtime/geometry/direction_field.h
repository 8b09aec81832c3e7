#pragma once

#include <hachure/runtime/geometry/sheet_curvature.h>
#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec3.hpp>

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// A smooth field of lines on sheets, across which the streaks of metal run: the direction of largest absolute
/// curvature where there is one. A line is the complex number whose angle is twice that of its two directions.
struct DirectionField {
    std::vector<std::complex<double>> lines; ///< per vertex, |z| = 1, in the vertex's frame
    /// Per triangle: half turns that the line makes around it, counter-clockwise; 0 but at singularities. On a closed
    /// sheet they add up to twice its Euler characteristic.
    std::vector<std::int8_t> half_turns;

    /// A direction of the line, in the vertex's frame.
    [[nodiscard]] double angle(std::uint32_t vertex) const { return 0.5 * std::arg(lines[vertex]); }
};

/// How much a curvature says about a direction, in [0, 1]: from (k1^2 - k2^2) / (k1^2 + k2^2), where `flat` is a
/// curvature that counts as none.
[[nodiscard]] double direction_confidence(double mean, double deviator, double flat);

/// The same per vertex of sheets.
[[nodiscard]] std::vector<double> direction_confidences(const SheetMetric& metric, const SheetCurvature& curvature);

/// Where nothing else decides: the line across the streaks on a surface with this unit normal, for streaks along Y and,
/// on surfaces across that, along X. A tangent vector squared: `first` is half the difference of the pattern's
/// strength along the unit tangents x and y, `second` the mixed part.
[[nodiscard]] std::complex<double> default_line(const glm::dvec3& x, const glm::dvec3& y);

/// The field that minimises its variation plus its distance from the directions of curvature, weighted by confidence,
/// plus very little of its distance from the default (Knoeppel et al. 2013, section 6.2, with the weight given at every
/// vertex instead of the norm of the solution): one linear system, whose solution is unique.
[[nodiscard]] DirectionField direction_field(const SurfaceSheets& sheets, const SheetMetric& metric,
                                             const SheetCurvature& curvature, std::span<const std::uint32_t> order,
                                             double detail);

} // namespace hachure::geometry
