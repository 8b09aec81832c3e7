#include <hachure/runtime/geometry/connection.h>
#include <hachure/runtime/geometry/direction_field.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hachure::geometry {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double noise_confidence = 0.1; // below it curvature is that of the mesh's irregularity
constexpr double full_confidence = 0.5;
constexpr double follow = 0.3;           // how far a sure direction yields to its neighbours, over the detail
constexpr double default_strength = 0.1; // over size^2; the first eigenvalue of a sphere is some 20 times this

Complex unit_or(Complex z, Complex otherwise) {
    const double size = std::abs(z);
    return size > 1e-300 && std::isfinite(size) ? z / size : otherwise;
}

/// Twice the turn of the line from one end of a half-edge to the other, beyond that of transport.
double line_turn(const SurfaceSheets& sheets, const SheetMetric& metric, const std::vector<Complex>& lines,
                 std::uint32_t h) {
    return std::arg(lines[sheets.head(h)] * std::conj(lines[sheets.tail(h)]) *
                    std::polar(1.0, -2.0 * metric.transport(h)));
}

} // namespace

double direction_confidence(double mean, double deviator, double flat) {
    const double h = std::abs(mean), d = std::abs(deviator), scale = 2.0 * (h * h + d * d) + flat * flat;
    const double raw = scale > 0.0 ? 4.0 * h * d / scale : 0.0;
    const double t = std::clamp((raw - noise_confidence) / (full_confidence - noise_confidence), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

std::vector<double> direction_confidences(const SheetMetric& metric, const SheetCurvature& curvature) {
    std::vector<double> result;
    for (std::size_t v = 0; v < curvature.mean.size(); ++v)
        result.push_back(direction_confidence(curvature.mean[v], std::abs(curvature.deviator[v]), 0.5 / metric.size));
    return result;
}

Complex default_line(const glm::dvec3& x, const glm::dvec3& y) {
    // The streaks' preference is the tensor diag(0.1, 1, 0) on the tangent plane; the line is across.
    constexpr glm::dvec3 along(0.1, 1.0, 0.0);
    const double xx = glm::dot(x * x, along), yy = glm::dot(y * y, along), xy = glm::dot(x * y, along);
    return -Complex(0.5 * (xx - yy), xy);
}

DirectionField direction_field(const SurfaceSheets& sheets, const SheetMetric& metric, const SheetCurvature& curvature,
                               std::span<const std::uint32_t> order, double detail) {
    const std::size_t count = sheets.positions.size();
    const std::vector<double> confidence = direction_confidences(metric, curvature);
    HermitianSystem system(order);
    std::vector<Complex> right(count);
    DirectionField field{.lines = std::vector<Complex>(count), .half_turns = {}};
    for (std::uint32_t v = 0; v < count; ++v) {
        const double own = metric.sheet_size[sheets.sheet[v]];
        const Complex wanted = 2.0 * curvature.mean[v] * curvature.deviator[v];
        const double strength = std::pow(confidence[v] / (follow * detail * own), 2),
                     fallback = default_strength / (own * own);
        const Complex other = default_line(metric.axis[v], glm::cross(metric.normal[v], metric.axis[v]));
        const Complex sum = metric.mass[v] * (strength * unit_or(wanted, 0.0) + fallback * other);
        system.add(v, v, metric.mass[v] * (strength + fallback));
        right[v] = sum;
        field.lines[v] = unit_or(other, 1.0);
    }
    for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h)
        if (sheets.is_first(h))
            add_turned_difference(system, sheets.tail(h), sheets.head(h), metric.weight[h],
                                  std::polar(1.0, 2.0 * metric.transport(h)));
    if (system.factorise()) {
        system.solve(right, right);
        for (std::size_t v = 0; v < count; ++v) field.lines[v] = unit_or(right[v], field.lines[v]);
    }
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) {
        double sum = 2.0 * metric.excess[t];
        for (std::uint32_t k = 0; k < 3; ++k) sum += line_turn(sheets, metric, field.lines, 3 * t + k);
        field.half_turns.push_back(static_cast<std::int8_t>(std::clamp(std::lround(sum / (2.0 * pi)), -100l, 100l)));
    }
    return field;
}

} // namespace hachure::geometry
