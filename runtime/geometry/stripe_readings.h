#pragma once

#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/stripe_phase.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <cstdint>
#include <vector>

namespace hachure::geometry {

/// How a phase reads somewhere else: sign * value + jump.
struct StripeReading {
    std::int8_t sign = 1;
    double jump = 0.0; ///< an even integer

    [[nodiscard]] double of(double value) const { return sign * value + jump; }
    /// This reading of what `inner` reads.
    [[nodiscard]] StripeReading after(const StripeReading& inner) const {
        return {static_cast<std::int8_t>(sign * inner.sign), sign * inner.jump + jump};
    }
    [[nodiscard]] StripeReading inverse() const { return {sign, -sign * jump}; }
};

/// How each corner of each triangle reads the value of its vertex, so that the corners of a triangle fit each other,
/// and neighbours read their common vertices alike wherever that is possible. Tips have no value and no reading.
class StripeReadings {
public:
    StripeReadings(const SurfaceSheets& sheets, const SheetMetric& metric, const StripePhase& phase);

    [[nodiscard]] const StripeReading& operator[](std::uint32_t corner) const { return corners_[corner]; }

private:
    [[nodiscard]] bool is_tip(std::uint32_t corner) const;
    [[nodiscard]] StripeReading along(std::uint32_t half_edge) const;
    void read_triangle(std::uint32_t corner, const StripeReading& reading);
    bool read_across(std::uint32_t half_edge);
    void spread_from(std::uint32_t triangle);

    const SurfaceSheets& sheets_;
    const SheetMetric& metric_;
    const StripePhase& phase_;
    std::vector<StripeReading> corners_;
    std::vector<std::uint8_t> done_; ///< per triangle
    std::vector<std::uint32_t> queue_;
};

} // namespace hachure::geometry
