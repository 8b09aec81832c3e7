#pragma once

#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// A coordinate across stripes that is known up to its sign and multiples of 2 (Knoeppel et al. 2015). Every vertex
/// has a value as its own direction (`DirectionField::angle`) counts it, and every half-edge says how its head's value
/// reads at its tail: `sign * value + jump`.
struct StripePhase {
    std::vector<double> value;     ///< per vertex, in sets
    std::vector<std::int8_t> sign; ///< per half-edge, +-1
    std::vector<double> jump;      ///< per half-edge, even integers
    /// Per triangle: 1 where its three half-edges agree, and at tips, where the tip has no value of its own; 0 at
    /// singularities.
    std::vector<std::uint8_t> whole;

    /// How the head of a half-edge reads at its tail.
    [[nodiscard]] double at_tail(const SurfaceSheets& sheets, std::uint32_t h) const {
        return sign[h] * value[sheets.head(h)] + jump[h];
    }
};

/// The phase whose growth along edges is closest to `rates` (per vertex, sets per metre) times the field: the smallest
/// eigenvector of the stripe energy, then made even in size.
[[nodiscard]] StripePhase stripe_phase(const SurfaceSheets& sheets, const SheetMetric& metric,
                                       const DirectionField& field, std::span<const double> rates,
                                       std::span<const std::uint32_t> order);

/// Draws the values again with all jumps kept, so that level lines follow the field: growth across the stripes'
/// direction is punished much more than an uneven rate.
void fit_phase(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
               std::span<const double> rates, std::span<const double> confidence, std::span<const std::uint32_t> order,
               StripePhase& phase);

/// Per vertex, how clear the stripes are around it (`StripeMesh::clarity`).
[[nodiscard]] std::vector<double> stripe_clarity(const SurfaceSheets& sheets, const SheetMetric& metric,
                                                 const DirectionField& field, std::span<const double> rates,
                                                 const StripePhase& phase);

/// Where a sheet's values are free to be shifted all together, makes that of its first vertex what the coordinate would
/// be on a plane through the object's middle.
void settle_phase(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                  std::span<const double> rates, StripePhase& phase);

} // namespace hachure::geometry
