#pragma once

#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/vec2.hpp>

#include <cstdint>

namespace hachure::geometry {

/// +1 where the directions `field.angle` at both ends of a half-edge are less than a quarter turn apart, and -1 where
/// one must be reversed.
[[nodiscard]] int line_sign(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                            std::uint32_t h);

/// A triangle in its plane, with the direction of the lines in it as corner 0 counts it.
struct FlatTriangle {
    glm::dvec2 gradient[3]; ///< of the function that is 1 at a corner and 0 at the others
    glm::dvec2 direction;   ///< unit; the mean of those at the corners
    int sign[3];            ///< of the corners' own directions against it
    double area;

    [[nodiscard]] glm::dvec2 across() const { return {-direction.y, direction.x}; }
};

/// False where the triangle has no area to speak of or is a singularity of the field,
/// and at tips.
[[nodiscard]] bool flatten(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                           std::uint32_t triangle, FlatTriangle& flat);

} // namespace hachure::geometry
