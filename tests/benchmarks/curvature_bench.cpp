// How exact principal curvatures are and what they cost: per method on an irregular torus of 10k vertices, clean and
// with noise, on one core; and on a million vertices, on all.

#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/fill_directions.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/curvature_case.h>
#include <hachure/tests/benchmarks/curvature_chart.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace hachure;
using namespace hachure::geometry;

/// The limits are what is published for the method, on such a mesh, on one core: RMS %, degrees, us/vertex.
struct Published {
    const char* name;
    CurvatureMethod method;
    std::uint32_t rings;
    double rms, degrees, us; ///< of the best in that noise, for the automatic choice
};

void report_accuracy(bench::Report& report, bool quick) {
    struct Noise {
        double noise;
        Published methods[5];
    };
    constexpr double slack = 1.1; // other meshes, other noise
    constexpr auto ring = CurvatureMethod::one_ring, two = CurvatureMethod::quadric, four = CurvatureMethod::quartic,
                   automatic = CurvatureMethod::automatic;
    constexpr Noise noises[] = {{0.0,
                                 {{"one ring", ring, 0, slack * 4.0, slack * 2.6, 0.9},
                                  {"degree 2, 2 rings", two, 2, slack * 1.5, slack * 1.2, 14.0},
                                  {"degree 2, 5 rings", two, 5, slack * 5.0, slack * 1.3, 80.0},
                                  {"degree 4, 3 rings", four, 3, slack * 0.07, slack * 0.05, 60.0},
                                  {"automatic", automatic, 0, slack * 0.07, slack * 0.05, 60.0}}},
                                {0.01,
                                 {{"one ring", ring, 0, slack * 11.0, slack * 7.5, 0.9},
                                  {"degree 2, 2 rings", two, 2, slack * 4.9, slack * 2.8, 14.0},
                                  {"degree 2, 5 rings", two, 5, slack * 5.0, slack * 1.4, 80.0},
                                  {"degree 4, 3 rings", four, 3, slack * 6.6, slack * 3.2, 60.0},
                                  {"automatic", automatic, 0, 4.9, 1.4, 14.0}}},
                                {0.05,
                                 {{"one ring", ring, 0, slack * 55.0, slack * 43.0, 0.9},
                                  {"degree 2, 2 rings", two, 2, slack * 23.0, slack * 14.0, 14.0},
                                  {"degree 2, 5 rings", two, 5, slack * 5.3, slack * 1.7, 80.0},
                                  {"degree 4, 3 rings", four, 3, slack * 32.0, slack * 19.0, 60.0},
                                  {"automatic", automatic, 0, 5.3, 1.7, 80.0}}}};
    for (const Noise& noise : noises) {
        bench::CurvatureCase mesh(test::CurvedKind::torus, noise.noise, quick ? 16 : 64);
        for (const Published& method : noise.methods) {
            const auto figures = mesh.measure(method.method, method.rings, quick ? 1 : 20);
            const std::string name = fmt::format("{:g} % noise, {}", 100.0 * noise.noise, method.name);
            report.add_limited(name + ": RMS", figures.rms, "%", method.rms);
            report.add_limited(name + ": direction", figures.degrees, "degrees", method.degrees);
            report.add_limited(name + ": cost", figures.us, "us/vertex", method.us);
        }
    }
}

/// The automatic method on all surfaces.
void report_surfaces(bench::Report& report, bool quick) {
    constexpr std::pair<const char*, test::CurvedKind> kinds[] = {{"sphere", test::CurvedKind::sphere},
                                                                  {"ellipsoid", test::CurvedKind::ellipsoid},
                                                                  {"cylinder", test::CurvedKind::cylinder},
                                                                  {"monkey saddle", test::CurvedKind::monkey_saddle}};
    for (const auto& [name, kind] : kinds)
        for (const double noise : {0.0, 0.01, 0.05}) {
            bench::CurvatureCase mesh(kind, noise, quick ? 16 : 64);
            const auto figures = mesh.measure(CurvatureMethod::automatic, 0, 1);
            const std::string title = fmt::format("{}, {:g} % noise, automatic", name, 100.0 * noise);
            report.add(title + ": RMS", figures.rms, "%");
            report.add(title + ": direction", figures.degrees, "degrees");
        }
}

double best_ms(int rounds, const std::function<void()>& work) {
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < rounds; ++i) {
        const double start = bench::now_ms();
        work();
        best = std::min(best, bench::now_ms() - start);
    }
    return best;
}

/// The automatic method, with all that it needs, on all threads.
void report_large(bench::Report& report, bool quick) {
    const test::CurvedCase mesh(test::CurvedKind::torus, {.cells = quick ? 16u : 640u});
    const std::size_t count = mesh.positions.size();
    std::vector<glm::vec2> curvatures(count);
    std::vector<glm::vec3> directions(count);
    std::vector<float> confidences(count);
    CurvatureJob job{.positions = mesh.positions,
                     .normals = mesh.normals,
                     .indices = mesh.indices,
                     .weld = mesh.weld,
                     .curvatures = curvatures,
                     .directions = directions,
                     .confidences = confidences,
                     .method = CurvatureMethod::automatic};
    const int rounds = quick ? 1 : 4;
    const std::string name = fmt::format("{:.3g} M vertices, automatic", 1e-6 * static_cast<double>(count));
    report.add_limited(name, 1e-3 * best_ms(rounds, [&] { job.run(); }), "s", 2.0);
    const std::clock_t start = std::clock();
    job.run();
    report.add_limited("its time on all cores together", static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC,
                       "s", 4.0);
    job.neighbours = &job.own_neighbours;
    report.add("the same on the same topology", 1e-3 * best_ms(rounds, [&] { job.run(); }), "s");
    FillDirectionsJob fill{.normals = mesh.normals,
                           .weld = mesh.weld,
                           .neighbours = &job.own_neighbours,
                           .directions = directions,
                           .confidences = confidences,
                           .filled = directions};
    report.add("directions filled, on top", 1e-3 * best_ms(rounds, [&] { fill.run(); }), "s");
}

int run(const bench::Arguments& arguments) {
    bench::Report report(arguments);
    report_accuracy(report, arguments.quick);
    report_surfaces(report, arguments.quick);
    report_large(report, arguments.quick);
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        // `--chart FILE [--quick]` writes what curvature_chart.gp draws, and measures nothing else.
        if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
            bench::write_curvature_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
            return 0;
        }
        return run(bench::parse_arguments(argc, argv, "Principal curvatures: errors and costs by method and noise."));
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_curvature: error: %s\n", error.what());
        return 1;
    }
}
