#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>
#include <hachure/systems/shade_strokes/shade_random.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hachure {
namespace {

constexpr double crease_angle = 1.0; // radians; edges that turn by more and share no normals are hard
constexpr std::size_t most_samples = 4;

void order_cells(ShadeMesh& mesh) {
    mesh.order.resize(mesh.cell_count());
    std::iota(mesh.order.begin(), mesh.order.end(), 0u);
    const auto rank = [](std::uint32_t cell) { return shade_bits(0, ShadePurpose::order, cell); };
    std::ranges::sort(mesh.order, {}, rank);
}

/// Spreads samples over the area of every cell.
void place_samples(ShadeMesh& mesh) {
    const ShadeCells& cells = mesh.cells;
    mesh.first_sample.push_back(0);
    for (std::uint32_t c = 0; c < cells.count(); ++c) {
        const std::size_t members = cells.first_member[c + 1] - cells.first_member[c];
        const std::size_t count = std::min(most_samples, std::max<std::size_t>(members, 1));
        for (std::size_t i = 0; i < count; ++i) {
            const double which = (double(i) + 0.5) / double(count);
            const ShadeCells::Point point = cells.point_in(c, which, 1.0 / 3.0, 1.0 / 3.0);
            mesh.samples.push_back({mesh.point(point.triangle, point.weight), 1.0f / static_cast<float>(count)});
        }
        mesh.first_sample.push_back(static_cast<std::uint32_t>(mesh.samples.size()));
    }
}

void average_normals(const geometry::SheetMetric& metric, ShadeMesh& mesh) {
    std::vector<glm::dvec3> sum(mesh.cell_count(), glm::dvec3(0.0));
    for (std::uint32_t t = 0; t < mesh.sheets.triangles.size(); ++t) {
        const auto& corners = mesh.sheets.triangles[t];
        const glm::dvec3 &a = mesh.sheets.positions[corners[0]], &b = mesh.sheets.positions[corners[1]],
                         &c = mesh.sheets.positions[corners[2]];
        const double n = mesh.cells.parts[t];
        const glm::dvec3 part = glm::cross(b - a, c - a) / (n * n);
        for (std::uint32_t i = mesh.cells.first_atom[t]; i < mesh.cells.first_atom[t + 1]; ++i)
            sum[mesh.cells.cell_of_atom[i]] += part;
    }
    for (std::uint32_t c = 0; c < sum.size(); ++c) {
        const double length = glm::length(sum[c]);
        if (length > 0.0) {
            mesh.normal.emplace_back(sum[c] / length);
            continue;
        }
        const std::uint32_t t = mesh.cells.triangle_of(mesh.cells.members[mesh.cells.first_member[c]]);
        mesh.normal.emplace_back(metric.normal[mesh.sheets.triangles[t][0]]);
    }
}

} // namespace

glm::dvec3 ShadeMesh::at(const SurfacePoint& point) const {
    const auto& corners = sheets.triangles[sheets.triangle_of[point.triangle]];
    const double u = point.u, v = point.v;
    return (1.0 - u - v) * sheets.positions[corners[0]] + u * sheets.positions[corners[1]] +
           v * sheets.positions[corners[2]];
}

ShadeMesh make_shade_mesh(const ShadeMeshInput& input) {
    HACHURE_ASSERT(input.normals.empty() || input.normals.size() == input.positions.size(), "a normal per vertex");
    HACHURE_ASSERT(input.curvatures.size() == input.directions.size(), "both or none");
    HACHURE_ASSERT(input.curvatures.empty() || input.curvatures.size() == input.positions.size(), "one per vertex");
    ShadeMesh mesh;
    mesh.health = geometry::inspect(input.positions, input.indices);
    mesh.sheets = geometry::cut_into_sheets(input.positions, input.normals, input.indices, crease_angle);
    const geometry::SheetMetric metric(mesh.sheets);
    mesh.size = static_cast<float>(metric.size);
    mesh.directions =
        shade_directions(mesh.sheets, metric, input.indices, input.normals, input.curvatures, input.directions);
    mesh.cells = make_shade_cells(mesh.sheets, metric.area, input.cells);
    const double total = std::accumulate(metric.area.begin(), metric.area.end(), 0.0);
    const double side = std::sqrt(total / static_cast<double>(std::max<std::size_t>(1, mesh.cell_count())));
    mesh.cell_side = side > 0.0 ? static_cast<float>(side) : mesh.size;
    order_cells(mesh);
    place_samples(mesh);
    average_normals(metric, mesh);
    return mesh;
}

std::string shade_mesh_report(const ShadeMesh& mesh) {
    std::string text;
    const auto add = [&](std::uint32_t count, const char* what) {
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    };
    add(mesh.health.boundary_edges, "border edges");
    add(mesh.health.non_manifold_edges, "edges of more than two triangles");
    add(mesh.health.mismatched_edges, "edges whose triangles disagree about their front");
    add(mesh.health.degenerate_triangles, "triangles with two corners at one place");
    add(mesh.health.sliver_triangles, "triangles without an area");
    add(mesh.health.duplicate_triangles, "repeated triangles");
    return text;
}

} // namespace hachure
