// What keeping shade strokes costs the CPU: against drawing them anew while the light turns, on a large mesh, by the
// cells touched, and while nothing moves. All times are those of the processor, of all threads together.

#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/shade_strokes_chart.h>
#include <hachure/tests/benchmarks/shade_strokes_frame.h>

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace hachure;

constexpr double turn = 1.0; // degrees per frame

void measure(bench::Report& report, const std::string& name, const geometry::Shape& shape, int frames, bool large) {
    const double start = bench::busy_ms();
    test::ShadeRig rig(shape);
    report.add(name + ": triangles", static_cast<double>(shape.indices.size() / 3), "");
    report.add(name + ": mesh built once", bench::busy_ms() - start, "ms");
    // From nothing and one more degree alternate, so that the machine's noise meets both.
    std::vector<double> anew, light, update, both, touched;
    for (int i = 0; i < frames; ++i) {
        if (i % (frames / 5 + 1) == 0) {
            rig.update.reset();
            const bench::ShadeFrameCost first = bench::shade_frame(rig, turn * i - 0.5);
            anew.push_back(first.ms());
        }
        const bench::ShadeFrameCost next = bench::shade_frame(rig, turn * i);
        light.push_back(next.light_ms);
        update.push_back(next.update_ms);
        both.push_back(next.ms());
        touched.push_back(rig.update.stats.touched);
    }
    report.add(name + ": cells", static_cast<double>(rig.mesh().cell_count()), "");
    report.add(name + ": segments", static_cast<double>(rig.chains().segments.live()), "");
    report.add(name + ": chains", static_cast<double>(rig.chains().chains.live()), "");
    report.add(name + ": from nothing", bench::median(anew), "ms");
    report.add(name + ": light sweep", bench::median(light), "ms");
    report.add(name + ": update", bench::median(update), "ms");
    report.add(name + ": cells touched", bench::median(touched), "");
    if (large)
        report.add_limited(name + ": sweep and update", bench::median(both), "ms", 16.0);
    else
        report.add_limited(name + ": sweep and update over from nothing", bench::median(both) / bench::median(anew),
                           "ratio", 0.05);
    const bench::ShadeFrameCost still = bench::shade_frame(rig, turn * (frames - 1));
    report.add_limited(name + ": cells swept when nothing moved", rig.update.stats.swept, "", 0.0);
    report.add(name + ": when nothing moved", still.ms(), "ms");
}

/// Cost by the cells touched: turns of the light of growing size.
void measure_turns(bench::Report& report, const geometry::Shape& shape) {
    test::ShadeRig rig(shape);
    bench::shade_frame(rig, 0.0);
    double at = 0.0;
    for (const double step : {0.25, 1.0, 4.0, 16.0, 64.0}) {
        std::vector<double> ms, touched;
        for (int i = 0; i < 9; ++i) {
            ms.push_back(bench::shade_frame(rig, at += step).update_ms);
            touched.push_back(rig.update.stats.touched);
        }
        report.add(fmt::format("bunny, {} degrees: cells touched", step), bench::median(touched), "");
        report.add(fmt::format("bunny, {} degrees: update", step), bench::median(ms), "ms");
    }
}

int run(int argc, char** argv) {
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "What keeping shade strokes costs the CPU while the light turns.");
    bench::Report report(arguments);
    if (arguments.quick) {
        measure(report, "torus", geometry::torus(1.0, 0.4, 24, 12), 3, false);
        return report.finish();
    }
    const std::filesystem::path file = arguments.model.empty() ? test::bunny_file : arguments.model;
    if (std::filesystem::exists(file)) {
        const geometry::Shape bunny = test::shape_of_file(file);
        measure(report, "bunny", bunny, 60, false);
        measure_turns(report, bunny);
    }
    measure(report, "torus", geometry::irregular_torus(1.0, 0.4, 1000, 500, 0.3, 1), 20, true);
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        // `--chart FILE [--quick]` writes what shade_strokes_chart.gp draws, and measures nothing else.
        if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
            bench::write_shade_strokes_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
            return 0;
        }
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_shade_strokes: error: %s\n", error.what());
        return 1;
    }
}
