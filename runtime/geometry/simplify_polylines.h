#pragma once

#include <hachure/runtime/geometry/polylines.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace hachure::geometry {

/// Leaves out points of lines that the others speak for (Douglas & Peucker 1973). First and last points stay, and with
/// them junctions; of a closed line also the one farthest from where it begins.
struct SimplifyPolylinesJob {
    const PolylineSet* lines = nullptr;
    float tolerance = 0.1f;          ///< how far a point that is left out may be from the line, pixels
    float width_tolerance = 0.1f;    ///< and how far its width from the line's there, pixels
    float opacity_tolerance = 0.02f; ///< and its opacity

    PolylineSet simplified{}; ///< out, kept from run to run; the same lines in the same order

    /// Asserts that there are lines, and that tolerances are above 0.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    std::vector<std::uint8_t> kept{};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stretches{};

private:
    [[nodiscard]] float deviation(std::uint32_t point, std::uint32_t first, std::uint32_t last) const;
    [[nodiscard]] std::uint32_t farthest_from(std::uint32_t point, std::uint32_t last) const;
    void keep_points(std::uint32_t first, std::uint32_t last);
    void simplify(const Polyline& line);
};

} // namespace hachure::geometry
