#include <hachure/runtime/geometry/sheet_metric.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hachure::geometry {
namespace {

using std::numbers::pi;
constexpr double tip_turn = 0.85 * 2.0 * pi; // a cone that opens by less than 116 degrees
constexpr double tip_weight = 1e-6;          // of the edges at a tip, against what they would weigh

/// A growing box.
struct Extent {
    glm::dvec3 low{std::numeric_limits<double>::max()}, high{-std::numeric_limits<double>::max()};

    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    [[nodiscard]] double diagonal() const {
        const double size = low.x <= high.x ? glm::length(high - low) : 0.0;
        return size > 0.0 && std::isfinite(size) ? size : 1.0;
    }
};

void measure_sizes(const SurfaceSheets& sheets, SheetMetric& m) {
    Extent all;
    std::vector<Extent> own(sheets.sheets);
    for (std::size_t v = 0; v < sheets.positions.size(); ++v) {
        all.add(sheets.positions[v]);
        own[sheets.sheet[v]].add(sheets.positions[v]);
    }
    m.size = all.diagonal();
    if (!sheets.positions.empty()) m.centre = 0.5 * (all.low + all.high);
    for (const Extent& bounds : own) m.sheet_size.push_back(bounds.diagonal());
}

void measure_triangles(const SurfaceSheets& sheets, SheetMetric& m, std::vector<double>& cotangent) {
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) {
        const auto& v = sheets.triangles[t];
        const glm::dvec3 p[3] = {sheets.positions[v[0]], sheets.positions[v[1]], sheets.positions[v[2]]};
        const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double twice_area = glm::length(cross);
        m.area[t] = 0.5 * twice_area;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
            const double dot = glm::dot(a, b), lengths = glm::dot(a, a) * glm::dot(b, b);
            m.length[3 * t + k] = glm::length(a);
            m.angle[3 * t + k] = std::atan2(twice_area, dot);
            cotangent[3 * t + k] = dot / std::max(twice_area, 1e-6 * std::abs(dot));
            // Max 1999: exact on a sphere.
            if (twice_area > 1e-6 * std::sqrt(lengths)) m.normal[v[k]] += cross / lengths;
        }
    }
}

/// Cotangents, but never so small or so large that a sliver tears the sheet or rules it.
double edge_weight(const SurfaceSheets& sheets, const std::vector<double>& cotangent, std::uint32_t h) {
    double sum = cotangent[SurfaceSheets::previous(h)];
    if (sheets.opposite[h] != SurfaceSheets::none) sum += cotangent[SurfaceSheets::previous(sheets.opposite[h])];
    return std::clamp(0.5 * sum, 0.01, 100.0);
}

void measure_angles(const SurfaceSheets& sheets, SheetMetric& m) {
    std::vector<double> stretch(sheets.positions.size());
    for (std::uint32_t v = 0; v < sheets.positions.size(); ++v) {
        sheets.each_out(v, [&](std::uint32_t h) { m.turn[v] += m.angle[h]; });
        stretch[v] = sheets.at_border(v) || !(m.turn[v] > 0.0) ? 1.0 : 2.0 * pi / m.turn[v];
        double along = 0.0;
        sheets.each_out(v, [&](std::uint32_t h) {
            m.tail_angle[h] = along * stretch[v];
            along += m.angle[h];
            m.head_angle[SurfaceSheets::previous(h)] = along * stretch[v];
        });
    }
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) {
        m.excess[t] = -pi;
        for (std::size_t k = 0; k < 3; ++k) m.excess[t] += m.angle[3 * t + k] * stretch[sheets.triangles[t][k]];
    }
}

/// Turns the frames so that they agree best with the edges in space.
void lay_axes(const SurfaceSheets& sheets, SheetMetric& m) {
    for (std::uint32_t v = 0; v < sheets.positions.size(); ++v) {
        const double length = glm::length(m.normal[v]);
        m.normal[v] = length > 0.0 && std::isfinite(length) ? m.normal[v] / length : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3& n = m.normal[v];
        const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
        const glm::dvec3 x(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), y(b, sign + n.y * n.y * a, -n.y);
        SheetMetric::Complex sum = 0.0;
        const auto add = [&](const glm::dvec3& edge, double angle) {
            sum += SheetMetric::Complex(glm::dot(edge, x), glm::dot(edge, y)) * std::polar(1.0, -angle);
        };
        sheets.each_out(v, [&](std::uint32_t h) {
            add(sheets.positions[sheets.head(h)] - sheets.positions[v], m.tail_angle[h]);
            const std::uint32_t in = SurfaceSheets::previous(h);
            if (sheets.opposite[in] == SurfaceSheets::none)
                add(sheets.positions[sheets.tail(in)] - sheets.positions[v], m.head_angle[in]);
        });
        const double size = std::abs(sum);
        m.axis[v] = size > 0.0 && std::isfinite(size) ? (sum.real() * x + sum.imag() * y) / size : x;
    }
}

/// Sharp vertices that stand alone.
void find_tips(const SurfaceSheets& sheets, SheetMetric& m) {
    const auto is_sharp = [&](std::uint32_t v) { return !sheets.at_border(v) && m.turn[v] < tip_turn; };
    for (std::uint32_t v = 0; v < sheets.positions.size(); ++v) {
        bool alone = is_sharp(v);
        if (alone) sheets.each_out(v, [&](std::uint32_t h) { alone = alone && !is_sharp(sheets.head(h)); });
        if (!alone) continue;
        m.tip[v] = 1;
        sheets.each_out(v, [&](std::uint32_t h) {
            m.weight[h] *= tip_weight;
            m.weight[sheets.opposite[h]] *= tip_weight;
        });
    }
}

} // namespace

SheetMetric::SheetMetric(const SurfaceSheets& sheets)
    : length(3 * sheets.triangles.size()), angle(length.size()), area(sheets.triangles.size()),
      tail_angle(length.size()), head_angle(length.size()), weight(length.size()), mass(sheets.positions.size()),
      turn(mass.size()), tip(mass.size()), excess(area.size()), normal(mass.size(), glm::dvec3(0.0)),
      axis(mass.size()) {
    measure_sizes(sheets, *this);
    std::vector<double> cotangent(length.size());
    measure_triangles(sheets, *this, cotangent);
    for (std::uint32_t h = 0; h < length.size(); ++h) weight[h] = edge_weight(sheets, cotangent, h);
    for (std::uint32_t t = 0; t < area.size(); ++t)
        for (const std::uint32_t v : sheets.triangles[t]) mass[v] += area[t] / 3.0;
    for (double& m : mass) m = std::max(m, 1e-12 * size * size);
    measure_angles(sheets, *this);
    find_tips(sheets, *this);
    lay_axes(sheets, *this);
}

bool SheetMetric::has_tip(const SurfaceSheets& sheets, std::uint32_t triangle) const {
    return std::ranges::any_of(sheets.triangles[triangle], [&](std::uint32_t v) { return tip[v] != 0; });
}

double SheetMetric::transport(std::uint32_t h) const { return head_angle[h] + pi - tail_angle[h]; }

SheetMetric::Complex SheetMetric::to_frame(std::uint32_t vertex, const glm::dvec3& v) const {
    return {glm::dot(v, axis[vertex]), glm::dot(v, glm::cross(normal[vertex], axis[vertex]))};
}

glm::dvec3 SheetMetric::to_space(std::uint32_t vertex, Complex z) const {
    return z.real() * axis[vertex] + z.imag() * glm::cross(normal[vertex], axis[vertex]);
}

} // namespace hachure::geometry
