#include <hachure/runtime/geometry/flat_triangle.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hachure::geometry {
namespace {

glm::dvec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

} // namespace

int line_sign(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field, std::uint32_t h) {
    const double turn = field.angle(sheets.head(h)) - field.angle(sheets.tail(h)) - metric.transport(h);
    return std::cos(turn) >= 0.0 ? 1 : -1;
}

bool flatten(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
             std::uint32_t triangle, FlatTriangle& flat) {
    const std::uint32_t h = 3 * triangle;
    const double l0 = metric.length[h], l1 = metric.length[h + 1], l2 = metric.length[h + 2];
    flat.area = metric.area[triangle];
    if (field.half_turns[triangle] != 0 || metric.has_tip(sheets, triangle)) return false;
    const double longest = std::max({l0, l1, l2});
    if (!(flat.area > 1e-6 * longest * longest)) return false;
    const glm::dvec2 corner[3] = {{0.0, 0.0}, {l0, 0.0}, l2 * at_angle(metric.angle[h])};
    // Directions of the half-edges in the plane.
    const double along[3] = {0.0, std::numbers::pi - metric.angle[h + 1], std::numbers::pi + metric.angle[h]};
    flat.sign[0] = 1;
    flat.sign[1] = line_sign(sheets, metric, field, h);
    flat.sign[2] = line_sign(sheets, metric, field, h + 2);
    glm::dvec2 sum(0.0);
    for (std::uint32_t k = 0; k < 3; ++k) {
        const glm::dvec2 edge = corner[(k + 2) % 3] - corner[(k + 1) % 3];
        flat.gradient[k] = glm::dvec2(-edge.y, edge.x) / (2.0 * flat.area);
        const std::uint32_t before = (k + 2) % 3;
        const double angle = field.angle(sheets.triangles[triangle][k]);
        const glm::dvec2 by_next = at_angle(angle - metric.tail_angle[h + k] + along[k]);
        const glm::dvec2 by_previous =
            at_angle(angle - metric.head_angle[h + before] + along[before] + std::numbers::pi);
        sum += static_cast<double>(flat.sign[k]) * (by_next + by_previous);
    }
    const double size = glm::length(sum);
    if (!(size > 1e-6)) return false;
    flat.direction = sum / size;
    return true;
}

} // namespace hachure::geometry
