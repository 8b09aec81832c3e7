#include <hachure/runtime/geometry/connection.h>
#include <hachure/runtime/geometry/flat_triangle.h>
#include <hachure/runtime/geometry/stripe_rate.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hachure::geometry {
namespace {

constexpr double evenness = 0.05; // of the rate, against the curl
constexpr double loyalty = 0.5;   // to the rate by curvature, over the square of the sheet's size
constexpr double most_crowded = 5.0;
constexpr double most_graded = 2.0;  // in the logarithm: a factor of 7.4
constexpr double most_thinned = 0.4; // a factor of 1.5: streaks far apart look like spots

/// The rate from curvature: close to the larger of two, and smooth.
double wanted_rate(double curvature, double size, double sets, double more) {
    const double turning = curvature / std::numbers::pi, flat = std::min(more, 2.0) / size;
    const double most = std::max(turning, flat), least = std::min(turning, flat);
    return sets * more * most * std::pow(1.0 + std::pow(least / most, 8), 0.125);
}

/// Per sheet: how many times as many sets. Lines turn back around a singularity, so that between two there must be room
/// for whole sets: more of them the closer singularities are.
std::vector<double> crowding(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field) {
    std::vector<double> result(sheets.sheets);
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
        if (field.half_turns[t] != 0 && !metric.has_tip(sheets, static_cast<std::uint32_t>(t)))
            result[sheets.sheet[sheets.triangles[t][0]]] += 1.0;
    for (double& count : result) count = std::clamp(std::sqrt(count), 1.0, most_crowded);
    return result;
}

/// Adds weight * (sum of c_k s_k - d)^2.
void add_row(SparseSystem& system, std::vector<double>& right, const std::array<std::uint32_t, 3>& v,
             const double (&c)[3], double d, double weight) {
    for (std::size_t i = 0; i < 3; ++i) {
        right[v[i]] += weight * c[i] * d;
        for (std::size_t k = 0; k <= i; ++k) system.add(v[i], v[k], weight * c[i] * c[k]);
    }
}

/// The curl of the unit field in a triangle: its circulation over the area.
double curl_of(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field, std::uint32_t t,
               const FlatTriangle& flat) {
    double sum = 0.0;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * t + k, next = (k + 1) % 3;
        const double a = flat.sign[k] * std::cos(field.angle(sheets.tail(h)) - metric.tail_angle[h]);
        const double b = -flat.sign[next] * std::cos(field.angle(sheets.head(h)) - metric.head_angle[h]);
        sum += 0.5 * metric.length[h] * (a + b);
    }
    return sum / flat.area;
}

} // namespace

std::vector<double> stripe_rates(const SurfaceSheets& sheets, const SheetMetric& metric,
                                 const SheetCurvature& curvature, const DirectionField& field,
                                 std::span<const std::uint32_t> order, double sets) {
    const std::size_t count = sheets.positions.size();
    SparseSystem system(order, 1);
    std::vector<double> right(count), wanted(count);
    const std::vector<double> more = crowding(sheets, metric, field);
    for (std::uint32_t v = 0; v < count; ++v) {
        wanted[v] = std::log(wanted_rate(curvature.largest(v), metric.size, sets, more[sheets.sheet[v]]));
        const double weight = loyalty * metric.mass[v] / std::pow(metric.sheet_size[sheets.sheet[v]], 2);
        system.add(v, v, weight);
        right[v] = weight * wanted[v];
    }
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) {
        FlatTriangle flat{};
        if (!flatten(sheets, metric, field, t, flat)) continue;
        double across[3];
        for (std::size_t k = 0; k < 3; ++k) across[k] = glm::dot(flat.gradient[k], flat.across());
        add_row(system, right, sheets.triangles[t], across, curl_of(sheets, metric, field, t, flat), flat.area);
    }
    for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h)
        if (sheets.is_first(h)) add_difference(system, sheets.tail(h), sheets.head(h), evenness * metric.weight[h]);
    std::vector<double> rates = wanted;
    if (system.factorise()) system.solve(right, rates);
    for (std::size_t v = 0; v < count; ++v)
        rates[v] = std::exp(std::clamp(rates[v], wanted[v] - most_thinned, wanted[v] + most_graded));
    return rates;
}

} // namespace hachure::geometry
