#include <hachure/runtime/geometry/flat_triangle.h>
#include <hachure/runtime/geometry/stripe_phase.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace hachure::geometry {
namespace {

constexpr double near_singularity = 0.1, far_singularity = 0.4; // in sets of stripes
constexpr double wide = 0.3, usual = 0.7;                       // growth over what it was to be

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Sets of stripes from each vertex to the nearest singular triangle, along edges; up to `far_singularity`.
std::vector<double> sets_to_singularities(const SurfaceSheets& sheets, const SheetMetric& metric,
                                          std::span<const double> rates, const StripePhase& phase) {
    std::vector<double> distance(sheets.positions.size(), std::numeric_limits<double>::max());
    using Place = std::pair<double, std::uint32_t>;
    std::priority_queue<Place, std::vector<Place>, std::greater<>> queue;
    const auto reach = [&](std::uint32_t v, double sets) {
        if (sets >= distance[v] || sets > far_singularity) return;
        distance[v] = sets;
        queue.emplace(sets, v);
    };
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
        if (phase.whole[t] == 0)
            for (const std::uint32_t v : sheets.triangles[t]) reach(v, 0.0);
    while (!queue.empty()) {
        const auto [sets, v] = queue.top();
        queue.pop();
        if (sets > distance[v]) continue;
        const auto spread = [&, from = v, so_far = sets](std::uint32_t other, std::uint32_t h) {
            reach(other, so_far + 0.5 * (rates[from] + rates[other]) * metric.length[h]);
        };
        sheets.each_out(v, [&](std::uint32_t h) {
            const std::uint32_t in = SurfaceSheets::previous(h);
            spread(sheets.head(h), h);
            spread(sheets.tail(in), in);
        });
    }
    return distance;
}

/// The mean growth around each vertex, over the rate.
std::vector<double> relative_growth(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                                    std::span<const double> rates, const StripePhase& phase) {
    std::vector<double> growth(sheets.positions.size()), area(growth.size());
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) {
        FlatTriangle flat{};
        if (phase.whole[t] == 0 || !flatten(sheets, metric, field, t, flat)) continue;
        const auto& v = sheets.triangles[t];
        const std::size_t h = 3 * std::size_t{t};
        const double jump[3] = {0.0, phase.jump[h], phase.jump[h] + phase.sign[h] * phase.jump[h + 1]};
        glm::dvec2 gradient(0.0);
        for (std::size_t k = 0; k < 3; ++k) gradient += (flat.sign[k] * phase.value[v[k]] + jump[k]) * flat.gradient[k];
        for (const std::uint32_t corner : v) {
            growth[corner] += flat.area * glm::length(gradient) / rates[corner];
            area[corner] += flat.area;
        }
    }
    for (std::size_t v = 0; v < growth.size(); ++v) growth[v] = area[v] > 0.0 ? growth[v] / area[v] : 1.0;
    return growth;
}

} // namespace

std::vector<double> stripe_clarity(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                                   std::span<const double> rates, const StripePhase& phase) {
    const std::vector<double> distance = sets_to_singularities(sheets, metric, rates, phase);
    std::vector<double> clarity = relative_growth(sheets, metric, field, rates, phase);
    for (std::size_t v = 0; v < clarity.size(); ++v)
        clarity[v] = smooth_step(wide, usual, clarity[v]) * smooth_step(near_singularity, far_singularity, distance[v]);
    return clarity;
}

} // namespace hachure::geometry
