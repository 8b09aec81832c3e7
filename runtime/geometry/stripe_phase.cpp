#include <hachure/runtime/geometry/connection.h>
#include <hachure/runtime/geometry/flat_triangle.h>
#include <hachure/runtime/geometry/stripe_phase.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace hachure::geometry {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double shift = 0.1;     // of the spectrum, over the square of a sheet's size: keeps the matrix regular
constexpr int linear_rounds = 20; // of inverse iteration
constexpr int even_rounds = 10;   // with the size of the phase made 1 everywhere after each

/// A number in [-1, 1] that belongs to a vertex. Real, so that it is the same for both directions of a line.
double start_value(std::uint32_t vertex) {
    std::uint32_t x = vertex * 0x9e3779b9u + 0x85ebca6bu;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    x ^= x >> 16;
    return static_cast<double>(x) / 2147483648.0 - 1.0;
}

/// Growth along every half-edge in sets, as its tail counts it.
std::vector<double> growth_along(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                                 std::span<const double> rates, const std::vector<std::int8_t>& sign) {
    std::vector<double> growth(sign.size());
    for (std::uint32_t h = 0; h < growth.size(); ++h) {
        const std::uint32_t a = sheets.tail(h), b = sheets.head(h);
        const double start = rates[a] * std::cos(field.angle(a) - metric.tail_angle[h]);
        const double end = -sign[h] * rates[b] * std::cos(field.angle(b) - metric.head_angle[h]);
        growth[h] = 0.5 * metric.length[h] * (start + end);
    }
    return growth;
}

/// Per sheet: scales the phase to a root mean square of 1.
void make_unit(const SurfaceSheets& sheets, const SheetMetric& metric, std::vector<double>& x) {
    std::vector<double> sum(sheets.sheets), mass(sheets.sheets);
    for (std::size_t v = 0; v < sheets.positions.size(); ++v) {
        sum[sheets.sheet[v]] += metric.mass[v] * (x[2 * v] * x[2 * v] + x[2 * v + 1] * x[2 * v + 1]);
        mass[sheets.sheet[v]] += metric.mass[v];
    }
    for (std::size_t v = 0; v < sheets.positions.size(); ++v) {
        const double square = sum[sheets.sheet[v]];
        const double scale = square > 0.0 ? std::sqrt(mass[sheets.sheet[v]] / square) : 0.0;
        x[2 * v] *= scale;
        x[2 * v + 1] *= scale;
    }
}

void make_even(std::vector<double>& x) {
    for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
        const double size = std::hypot(x[i], x[i + 1]);
        if (!(size > 0.0)) continue;
        x[i] /= size;
        x[i + 1] /= size;
    }
}

/// The smoothest phase that grows so along the edges: two numbers per vertex.
std::vector<double> smoothest(const SurfaceSheets& sheets, const SheetMetric& metric, const std::vector<double>& growth,
                              const std::vector<std::int8_t>& sign, std::span<const std::uint32_t> order) {
    const std::size_t count = sheets.positions.size();
    SparseSystem system(order, 2);
    std::vector<double> x(2 * count), inertia(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        inertia[v] = shift * metric.mass[v] / std::pow(metric.sheet_size[sheets.sheet[v]], 2);
        for (std::size_t k = 0; k < 2; ++k) system.add(2 * v + k, 2 * v + k, inertia[v]);
        x[2 * v] = start_value(v);
    }
    for (std::uint32_t h = 0; h < growth.size(); ++h)
        if (sheets.is_first(h))
            add_turned_difference(system, sheets.tail(h), sheets.head(h), metric.weight[h],
                                  std::polar(1.0, pi * growth[h]), sign[h] < 0);
    if (!system.factorise()) return x;
    for (int round = 0; round < linear_rounds + even_rounds; ++round) {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] *= inertia[i / 2];
        system.solve(x, x);
        make_unit(sheets, metric, x);
        if (round >= linear_rounds) make_even(x);
    }
    return x;
}

/// Whether going around a triangle leads back to the same value.
bool closes(const StripePhase& phase, std::uint32_t triangle) {
    const std::uint32_t h = 3 * triangle;
    if (phase.sign[h] * phase.sign[h + 1] * phase.sign[h + 2] < 0) return false;
    return phase.jump[h] + phase.sign[h] * (phase.jump[h + 1] + phase.sign[h + 1] * phase.jump[h + 2]) == 0.0;
}

/// The value at some vertex, and how the other vertices of its sheet count along with it: +-1, and whether they can.
struct Orientation {
    std::vector<std::int8_t> sign;
    std::vector<std::uint8_t> free; ///< per sheet
    std::vector<std::uint32_t> first;
};

Orientation orient(const SurfaceSheets& sheets, const SheetMetric& metric, const StripePhase& phase) {
    Orientation result{.sign = std::vector<std::int8_t>(sheets.positions.size(), 0),
                       .free = std::vector<std::uint8_t>(sheets.sheets, 1),
                       .first = {}};
    std::vector<std::uint32_t> queue;
    for (std::uint32_t seed = 0; seed < result.sign.size(); ++seed) {
        if (result.sign[seed] != 0 || metric.tip[seed] != 0) continue;
        if (result.first.size() <= sheets.sheet[seed]) result.first.resize(sheets.sheet[seed] + 1, SurfaceSheets::none);
        if (result.first[sheets.sheet[seed]] == SurfaceSheets::none) result.first[sheets.sheet[seed]] = seed;
        result.sign[seed] = 1;
        queue.assign(1, seed);
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const std::uint32_t v = queue[i];
            sheets.each_out(v, [&](std::uint32_t h) {
                for (const std::uint32_t side : {h, SurfaceSheets::previous(h)}) {
                    const std::uint32_t other = side == h ? sheets.head(h) : sheets.tail(side);
                    if (metric.tip[other] != 0) continue;
                    const auto wanted = static_cast<std::int8_t>(result.sign[v] * phase.sign[side]);
                    if (result.sign[other] == 0) {
                        result.sign[other] = wanted;
                        queue.push_back(other);
                    } else if (result.sign[other] != wanted) {
                        result.free[sheets.sheet[v]] = 0;
                    }
                }
            });
        }
    }
    result.first.resize(sheets.sheets, SurfaceSheets::none);
    return result;
}

} // namespace

StripePhase stripe_phase(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                         std::span<const double> rates, std::span<const std::uint32_t> order) {
    StripePhase phase;
    for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h)
        phase.sign.push_back(static_cast<std::int8_t>(line_sign(sheets, metric, field, h)));
    const std::vector<double> growth = growth_along(sheets, metric, field, rates, phase.sign);
    const std::vector<double> x = smoothest(sheets, metric, growth, phase.sign, order);
    for (std::size_t v = 0; v < sheets.positions.size(); ++v)
        phase.value.push_back(std::atan2(x[2 * v + 1], x[2 * v]) / pi);
    phase.jump.resize(growth.size());
    for (std::uint32_t h = 0; h < growth.size(); ++h) {
        if (!sheets.is_first(h)) continue;
        const double difference = phase.sign[h] * phase.value[sheets.head(h)] - phase.value[sheets.tail(h)] - growth[h];
        phase.jump[h] = -2.0 * std::round(0.5 * difference);
        if (const std::uint32_t back = sheets.opposite[h]; back != SurfaceSheets::none)
            phase.jump[back] = -phase.sign[h] * phase.jump[h];
    }
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t)
        phase.whole.push_back(metric.has_tip(sheets, t) || (field.half_turns[t] == 0 && closes(phase, t)) ? 1 : 0);
    return phase;
}

void settle_phase(const SurfaceSheets& sheets, const SheetMetric& metric, const DirectionField& field,
                  std::span<const double> rates, StripePhase& phase) {
    const Orientation orientation = orient(sheets, metric, phase);
    std::vector<double> shifts(sheets.sheets);
    for (std::uint32_t s = 0; s < sheets.sheets; ++s) {
        const std::uint32_t v = orientation.first[s];
        if (v == SurfaceSheets::none || orientation.free[s] == 0) continue;
        const glm::dvec3 across = metric.to_space(v, std::polar(1.0, field.angle(v)));
        const glm::dvec3 place = sheets.positions[v] - metric.centre;
        shifts[s] = rates[v] * (across.x * place.x + across.y * place.y + across.z * place.z) - phase.value[v];
    }
    for (std::size_t v = 0; v < sheets.positions.size(); ++v)
        phase.value[v] += orientation.sign[v] * shifts[sheets.sheet[v]];
}

} // namespace hachure::geometry
