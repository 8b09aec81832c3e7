#pragma once

#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Curvature on sheets at some scale. With principal curvatures k1 and k2 at angles a and a + pi / 2 of a vertex's
/// frame, `mean` is (k1 + k2) / 2 and `deviator` is (k1 - k2) / 2 exp(2ia): smooth functions of the surface, whichever
/// of the two is called the first. The square of the shape operator has the deviator 2 * mean * deviator, so that the
/// angle of this product is twice that of the direction of largest absolute curvature.
struct SheetCurvature {
    std::vector<double> mean;                   ///< per vertex, 1/metre
    std::vector<std::complex<double>> deviator; ///< per vertex, 1/metre

    [[nodiscard]] double largest(std::size_t vertex) const {
        return std::abs(mean[vertex]) + std::abs(deviator[vertex]);
    }
};

/// The curvature smoothed to a length of `detail` times the size of each sheet (an implicit step of the heat equation
/// for scalars and for deviators). `order` as of `elimination_order` for the edges of the sheets.
[[nodiscard]] SheetCurvature sheet_curvature(const SurfaceSheets& sheets, const SheetMetric& metric,
                                             std::span<const std::uint32_t> order, double detail);

/// Pairs of vertices that an edge joins.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> sheet_edges(const SurfaceSheets& sheets);

} // namespace hachure::geometry
