#include <hachure/runtime/geometry/connection.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/sheet_curvature.h>

#include <cmath>
#include <numeric>

namespace hachure::geometry {
namespace {

SheetCurvature raw_curvature(const SurfaceSheets& sheets, const SheetMetric& metric) {
    const std::size_t count = sheets.positions.size();
    std::vector<glm::vec3> positions(sheets.positions.begin(), sheets.positions.end());
    std::vector<glm::vec3> normals(metric.normal.begin(), metric.normal.end()), directions(count);
    std::vector<std::uint32_t> indices, weld(count);
    for (const auto& t : sheets.triangles) indices.insert(indices.end(), t.begin(), t.end());
    std::iota(weld.begin(), weld.end(), 0u);
    std::vector<glm::vec2> curvatures(count);
    CurvatureJob job{.positions = positions,
                     .normals = normals,
                     .indices = indices,
                     .weld = weld,
                     .curvatures = curvatures,
                     .directions = directions};
    job.run();
    SheetCurvature result;
    for (std::uint32_t v = 0; v < count; ++v) {
        const double k1 = curvatures[v].x, k2 = curvatures[v].y;
        const SheetMetric::Complex d = metric.to_frame(v, glm::dvec3(directions[v]));
        const double square = std::norm(d);
        result.mean.push_back(0.5 * (k1 + k2));
        result.deviator.push_back(square > 0.0 ? 0.5 * (k1 - k2) * d * d / square : 0.0);
    }
    return result;
}

} // namespace

std::vector<std::array<std::uint32_t, 2>> sheet_edges(const SurfaceSheets& sheets) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h)
        if (sheets.is_first(h)) edges.push_back({sheets.tail(h), sheets.head(h)});
    return edges;
}

SheetCurvature sheet_curvature(const SurfaceSheets& sheets, const SheetMetric& metric,
                               std::span<const std::uint32_t> order, double detail) {
    SheetCurvature curvature = raw_curvature(sheets, metric);
    const std::size_t count = sheets.positions.size();
    SparseSystem scalars(order, 1);
    HermitianSystem deviators(order);
    std::vector<double> right(count);
    std::vector<std::complex<double>> rights(count);
    // After time t the heat kernel has a deviation of sqrt(2t).
    const auto time = [&](std::uint32_t v) { return 0.5 * std::pow(detail * metric.sheet_size[sheets.sheet[v]], 2); };
    for (std::uint32_t v = 0; v < count; ++v) {
        scalars.add(v, v, metric.mass[v]);
        deviators.add(v, v, metric.mass[v]);
        right[v] = metric.mass[v] * curvature.mean[v];
        rights[v] = metric.mass[v] * curvature.deviator[v];
    }
    for (std::uint32_t h = 0; h < sheets.opposite.size(); ++h) {
        if (!sheets.is_first(h)) continue;
        const std::uint32_t a = sheets.tail(h), b = sheets.head(h);
        const double weight = metric.weight[h] * time(a);
        add_difference(scalars, a, b, weight);
        add_turned_difference(deviators, a, b, weight, std::polar(1.0, 2.0 * metric.transport(h)));
    }
    if (!scalars.factorise() || !deviators.factorise()) return curvature;
    scalars.solve(right, curvature.mean);
    deviators.solve(rights, curvature.deviator);
    return curvature;
}

} // namespace hachure::geometry
