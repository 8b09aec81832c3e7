#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/benchmarks/edge_lines_case.h>
#include <hachure/tests/benchmarks/edge_lines_chart.h>

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

namespace hachure::bench {
namespace {

std::string rows(std::uint32_t across, bool quick) {
    geometry::Shape shape = geometry::irregular_torus(1.0, 0.4, 2 * across, across, 0.33, 5);
    SilhouetteCase mesh(std::move(shape.positions), std::move(shape.indices));
    const auto planes = [&] { geometry::face_planes(mesh.positions, mesh.indices, mesh.planes); };
    const int frames = quick ? 2 : 12, rounds = quick ? 1 : 6;
    const std::vector<double> rigid = frame_ms({[&](int frame) { mesh.plain_loop(mesh.eye(frame)); },
                                                [&](int frame) {
                                                    mesh.by_tree.eye = mesh.eye(frame);
                                                    mesh.by_tree.run();
                                                },
                                                [&](int frame) { mesh.plain_faces(mesh.eye(frame)); }},
                                               frames, rounds);
    const auto loop = [&](int frame) {
        planes();
        mesh.loop.eye = mesh.eye(frame);
        mesh.loop.run();
    };
    const auto parallel_loop = [&](int frame) {
        geometry::face_planes_in_parallel(mesh.positions, mesh.indices, mesh.planes);
        mesh.loop.eye = mesh.eye(frame);
        geometry::select_in_parallel(mesh.loop);
    };
    const auto refit = [&](int frame) {
        geometry::face_planes_in_parallel(mesh.positions, mesh.indices, mesh.planes);
        mesh.tree.refit(mesh.planes);
        mesh.by_tree.eye = mesh.eye(frame);
        mesh.by_tree.run();
    };
    const std::vector<double> deforming = frame_ms({loop, parallel_loop, refit}, quick ? 1 : 3, quick ? 1 : 12);
    const std::size_t triangles = mesh.planes.size();
    const auto row = [&](const char* panel, const char* series, double ms) {
        return fmt::format("{},{},{},{:.5g}\n", panel, series, triangles, ms);
    };
    return row("rigid", "loop", rigid[0]) + row("rigid", "tree", rigid[1]) + row("rigid", "faces", rigid[2]) +
           row("deforming", "loop", deforming[0]) + row("deforming", "parallel", deforming[1]) +
           row("deforming", "refit", deforming[2]);
}

} // namespace

void write_edge_lines_chart(const std::filesystem::path& path, bool quick) {
    std::string csv = "panel,series,triangles,ms\n";
    for (const std::uint32_t across : {16u, 32u, 64u, 128u, 256u, 500u, 700u})
        if (!quick || across < 64) csv += rows(across, quick);
    assets::write_file_atomically(path, std::as_bytes(std::span(csv.data(), csv.size())));
}

} // namespace hachure::bench
