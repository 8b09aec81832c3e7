#include <hachure/runtime/geometry/connection.h>
#include <hachure/runtime/geometry/sheet_normals.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

constexpr double least_change = 2e-3; // radians
constexpr double most_bend = 0.5;     // radians that a surface may turn over the length of smoothing

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0.1 && std::isfinite(length) ? v / length : otherwise;
}

/// The normal `to`, but a change as small as irregular triangles make counts as none.
glm::dvec3 leant(const glm::dvec3& from, const glm::dvec3& to) {
    const double change = glm::length(to - from);
    return change > least_change ? glm::normalize(to + least_change / change * (from - to)) : from;
}

} // namespace

std::vector<glm::dvec3> sheet_normals(const SurfaceSheets& sheets, const SheetMetric& metric,
                                      std::span<const glm::vec3> normals, std::span<const std::uint32_t> indices) {
    if (normals.empty()) return metric.normal;
    std::vector<glm::dvec3> result(sheets.positions.size(), glm::dvec3(0.0));
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            result[sheets.triangles[t][k]] +=
                metric.angle[3 * t + k] * glm::dvec3(normals[indices[3 * std::size_t{sheets.face[t]} + k]]);
    for (std::size_t v = 0; v < result.size(); ++v) {
        const double length = glm::length(result[v]);
        result[v] = length > 1e-3 * metric.turn[v] ? result[v] / length : metric.normal[v];
    }
    return result;
}

std::vector<glm::dvec3> smooth_sheet_normals(const SurfaceSheets& sheets, const SheetMetric& metric,
                                             const SheetCurvature& curvature, const std::vector<glm::dvec3>& normals,
                                             std::span<const std::uint32_t> order, double detail) {
    const std::size_t count = sheets.positions.size();
    SparseSystem system(order, 1);
    std::vector<double> time(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        const double length =
            std::min(detail * metric.sheet_size[sheets.sheet[v]], most_bend / std::max(curvature.largest(v), 1e-30));
        time[v] = 0.5 * length * length; // as that of curvature
        system.add(v, v, metric.mass[v]);
    }
    for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h) {
        if (!sheets.is_first(h)) continue;
        const std::uint32_t a = sheets.tail(h), b = sheets.head(h);
        add_difference(system, a, b, metric.weight[h] * std::min(time[a], time[b]));
    }
    if (!system.factorise()) return normals;
    std::vector<glm::dvec3> result(count);
    std::vector<double> x(count);
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t v = 0; v < count; ++v) x[v] = metric.mass[v] * normals[v][axis];
        system.solve(x, x);
        for (std::size_t v = 0; v < count; ++v) result[v][axis] = x[v];
        // Once more for what that took away: bends keep their normals to the second order of the time, bumps go all the
        // same.
        for (std::size_t v = 0; v < count; ++v) x[v] = metric.mass[v] * (normals[v][axis] - result[v][axis]);
        system.solve(x, x);
        for (std::size_t v = 0; v < count; ++v) result[v][axis] += x[v];
    }
    for (std::size_t v = 0; v < count; ++v) result[v] = leant(normals[v], unit_or(result[v], normals[v]));
    return result;
}

} // namespace hachure::geometry
