#include <hachure/runtime/geometry/connection.h>
#include <hachure/runtime/geometry/flat_triangle.h>
#include <hachure/runtime/geometry/stripe_phase.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure::geometry {
namespace {

constexpr double obedience = 40.0; // to the direction, where curvature is sure of it, against an even rate
constexpr double least_obedience = 2.0;
constexpr double inertia = 1e-6; // keeps the matrix regular, over the square of a sheet's size
constexpr int rounds = 4;        // in each, directions are measured by the rates of the one before
constexpr double most_uneven = 10.0;

/// The growth of the phase in a triangle, as corner 0 counts it: the corners' values are `sign * value + jump`.
struct Growth {
    FlatTriangle flat;
    double jump[3];

    [[nodiscard]] glm::dvec2 gradient(const std::array<std::uint32_t, 3>& v, const std::vector<double>& value) const {
        glm::dvec2 sum(0.0);
        for (std::size_t k = 0; k < 3; ++k) sum += (flat.sign[k] * value[v[k]] + jump[k]) * flat.gradient[k];
        return sum;
    }
};

bool growth_in(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
               const StripePhase& phase, std::uint32_t t, Growth& growth) {
    if (phase.whole[t] == 0 || !flatten(sheets, metric, field, t, growth.flat)) return false;
    const std::uint32_t h = 3 * t;
    growth.jump[0] = 0.0;
    growth.jump[1] = phase.jump[h];
    growth.jump[2] = phase.jump[h] + phase.sign[h] * phase.jump[h + 1];
    return true;
}

/// The normal equations of one round.
struct PhaseEquations {
    SparseSystem system;
    std::vector<double> right;

    /// weight * (gradient . direction - wanted)^2
    void add(const std::array<std::uint32_t, 3>& v, const Growth& growth, const glm::dvec2& direction, double wanted,
             double weight) {
        double c[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const double along = glm::dot(growth.flat.gradient[k], direction);
            c[k] = growth.flat.sign[k] * along;
            wanted -= growth.jump[k] * along;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            right[v[i]] += weight * c[i] * wanted;
            for (std::size_t k = 0; k <= i; ++k) system.add(v[i], v[k], weight * c[i] * c[k]);
        }
    }
};

/// How the next round is to pull at the growth across the stripes, and along them.
struct Wish {
    double growth, weight, across_weight;
};

/// The energy per area is log(own / rate)^2 + strict * (along / own)^2, where `own` is the growth in the direction
/// across the stripes: it does not change with the scale of both, so that a triangle gains nothing by growing less.
/// Above the rate, the weight that has the energy's value; below, the step of Newton and Gauss, which pulls up as
/// strongly as what grows along the streaks pulls down.
Wish wish_for(double own, double rate) {
    own = std::clamp(own, rate / most_uneven, rate * most_uneven);
    const double ratio = std::log(own / rate), across = 1.0 / (own * own);
    if (ratio < 0.0) return {own * (1.0 - ratio), across, across};
    const double off = own - rate;
    return {rate, off > 1e-3 * rate ? ratio * ratio / (off * off) : 1.0 / (rate * rate), across};
}

double mean_of(std::span<const double> values, const std::array<std::uint32_t, 3>& v) {
    return (values[v[0]] + values[v[1]] + values[v[2]]) / 3.0;
}

} // namespace

void fit_phase(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
               std::span<const double> rates, std::span<const double> confidence, std::span<const std::uint32_t> order,
               StripePhase& phase) {
    const std::size_t count = sheets.positions.size();
    for (int round = 0; round < rounds; ++round) {
        PhaseEquations equations{SparseSystem(order, 1), std::vector<double>(count)};
        for (std::uint32_t v = 0; v < count; ++v) {
            const double weight = inertia * metric.mass[v] / std::pow(metric.sheet_size[sheets.sheet[v]], 2);
            equations.system.add(v, v, weight);
            equations.right[v] += weight * phase.value[v];
        }
        for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) {
            Growth growth{};
            if (!growth_in(sheets, metric, field, phase, t, growth)) continue;
            const auto& v = sheets.triangles[t];
            const double rate = mean_of(rates, v), sure = mean_of(confidence, v);
            const double strict =
                std::min(least_obedience + (obedience - least_obedience) * sure, std::pow(4.0, round));
            const Wish wish = round == 0
                                  ? Wish{rate, 1.0 / (rate * rate), 1.0 / (rate * rate)}
                                  : wish_for(glm::dot(growth.gradient(v, phase.value), growth.flat.direction), rate);
            equations.add(v, growth, growth.flat.direction, wish.growth, growth.flat.area * wish.weight);
            equations.add(v, growth, growth.flat.across(), 0.0, strict * growth.flat.area * wish.across_weight);
        }
        // Edges hold together what no triangle does: at tips, singularities and slivers.
        for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h) {
            if (!sheets.is_first(h)) continue;
            const std::uint32_t a = sheets.tail(h), b = sheets.head(h);
            const double rate = 0.5 * (rates[a] + rates[b]);
            const double weight = 1e-2 * metric.weight[h] / (rate * rate);
            const double start = rates[a] * std::cos(field.angle(a) - metric.tail_angle[h]);
            const double end = -phase.sign[h] * rates[b] * std::cos(field.angle(b) - metric.head_angle[h]);
            const double wanted = 0.5 * metric.length[h] * (start + end) - phase.jump[h];
            equations.system.add(a, a, weight);
            equations.system.add(b, b, weight);
            equations.system.add(a, b, -weight * phase.sign[h]);
            equations.right[a] -= weight * wanted;
            equations.right[b] += weight * phase.sign[h] * wanted;
        }
        if (!equations.system.factorise()) return;
        equations.system.solve(equations.right, phase.value);
    }
}

} // namespace hachure::geometry
