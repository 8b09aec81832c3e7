#include <hachure/runtime/geometry/stripe_readings.h>

namespace hachure::geometry {

StripeReadings::StripeReadings(const SurfaceSheets& sheets, const SheetMetric& metric, const StripePhase& phase)
    : sheets_(sheets), metric_(metric), phase_(phase), corners_(sheets.opposite.size()),
      done_(sheets.triangles.size(), 0) {
    for (std::uint32_t t = 0; t < done_.size(); ++t)
        if (done_[t] == 0 && phase.whole[t] != 0) spread_from(t);
    for (std::uint32_t t = 0; t < done_.size(); ++t) { // singular ones
        if (done_[t] != 0) continue;
        bool known = false;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3 && !known; ++h) {
            const std::uint32_t other = sheets.opposite[h];
            known = other != SurfaceSheets::none && done_[other / 3] != 0 && read_across(other);
        }
        if (!known) read_triangle(3 * t, {});
    }
}

bool StripeReadings::is_tip(std::uint32_t corner) const { return metric_.tip[sheets_.tail(corner)] != 0; }

StripeReading StripeReadings::along(std::uint32_t half_edge) const {
    return {phase_.sign[half_edge], phase_.jump[half_edge]};
}

/// Reads a triangle's other corners from one that is no tip.
void StripeReadings::read_triangle(std::uint32_t corner, const StripeReading& reading) {
    const std::uint32_t next = SurfaceSheets::next(corner), previous = SurfaceSheets::previous(corner);
    corners_[corner] = reading;
    if (!is_tip(next)) corners_[next] = reading.after(along(corner));
    if (!is_tip(previous)) corners_[previous] = reading.after(along(previous).inverse());
    done_[corner / 3] = 1;
}

/// Reads the triangle behind a half-edge of one that is read, unless that is done or there is none.
bool StripeReadings::read_across(std::uint32_t half_edge) {
    const std::uint32_t other = sheets_.opposite[half_edge];
    if (other == SurfaceSheets::none || done_[other / 3] != 0) return false;
    if (!is_tip(half_edge))
        read_triangle(SurfaceSheets::next(other), corners_[half_edge]);
    else
        read_triangle(other, corners_[SurfaceSheets::next(half_edge)]);
    return true;
}

void StripeReadings::spread_from(std::uint32_t triangle) {
    queue_.assign(1, triangle);
    read_triangle(is_tip(3 * triangle) ? 3 * triangle + 1 : 3 * triangle, {});
    for (std::size_t i = 0; i < queue_.size(); ++i) {
        for (std::uint32_t h = 3 * queue_[i]; h < 3 * queue_[i] + 3; ++h) {
            const std::uint32_t other = sheets_.opposite[h];
            if (other == SurfaceSheets::none || phase_.whole[other / 3] == 0) continue;
            if (read_across(h)) queue_.push_back(other / 3);
        }
    }
}

} // namespace hachure::geometry
