#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/deform_chart.h>
#include <hachure/tests/support/bent_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>

namespace hachure::bench {
namespace {

using geometry::SkinMethod;

/// Microseconds per vertex of the steps that the ways are made of: the best of some rounds.
struct Costs {
    double positions, blended, carry, normals, curvature;
};

template <class Job> double cost(Job&& job, std::size_t vertices, int rounds) {
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < rounds; ++i) {
        const double start = now_ms();
        job();
        best = std::min(best, now_ms() - start);
    }
    return 1000.0 * best / static_cast<double>(vertices);
}

Costs costs(test::BentMesh& mesh, SkinMethod method, int rounds) {
    const std::size_t count = mesh.positions.size();
    geometry::SkinJob skin = mesh.skin_job(method), positions = skin;
    positions.rest_normals = {};
    positions.normals = {};
    geometry::CarryCurvatureJob carry = mesh.carry_job(method);
    return {cost([&] { positions.run(); }, count, rounds), cost([&] { skin.run(); }, count, rounds),
            cost([&] { carry.run(); }, count, rounds), cost([&] { mesh.normals_job.run(); }, count, rounds),
            cost([&] { mesh.curvature_job.run(); }, count, rounds)};
}

std::string row(const char* panel, const char* way, SkinMethod method, int degrees, double us, double rms) {
    const char* name = method == SkinMethod::linear ? "LBS" : "DQS";
    return fmt::format("{},{} {},{},{:.5g},{:.4g}\n", panel, name, way, degrees, us, rms);
}

} // namespace

void write_deform_chart(const std::filesystem::path& path, bool quick) {
    test::BentMesh mesh(quick ? 16 : 96);
    std::string csv = "panel,series,degrees,us,rms\n";
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion})
        for (const int degrees : {30, 60, 90, 120}) {
            const test::BentErrors errors = mesh.errors(method, degrees);
            const Costs c = costs(mesh, method, quick ? 1 : 100);
            const double normals = c.positions + c.normals;
            csv += row("normals", "blended", method, degrees, c.blended, errors.blended_normals);
            csv += row("normals", "recomputed", method, degrees, normals, errors.recomputed_normals);
            csv += row("directions", "carried", method, degrees, c.blended + c.carry, errors.carried_directions);
            csv +=
                row("directions", "recomputed", method, degrees, normals + c.curvature, errors.recomputed_directions);
        }
    assets::write_file_atomically(path, std::as_bytes(std::span(csv.data(), csv.size())));
}

} // namespace hachure::bench
