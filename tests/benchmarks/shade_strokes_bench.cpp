// What keeping shade strokes costs the CPU: against drawing them anew while the light turns, on a large mesh, by the
// cells touched, and while nothing moves. All times are those of the processor, of all threads together.

#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/support/shade_rig.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace hachure;

constexpr double turn = 1.0; // degrees per frame

/// Milliseconds that all threads have computed so far: other programs on the machine don't count.
double busy_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One frame: milliseconds of the sweep over the light and of the update.
struct Frame {
    double light_ms, update_ms;
};

Frame frame(test::ShadeRig& rig, double degrees) {
    const double start = busy_ms();
    const auto a = static_cast<float>(glm::radians(degrees));
    const std::vector<ShadingLight> lights{test::shade_sun({std::sin(a), 0.4f, std::cos(a)})};
    rig.light.lights = lights;
    rig.light.run();
    rig.light.lights = {};
    const double middle = busy_ms();
    rig.update.changed = rig.light.swept;
    rig.update.run();
    return {middle - start, busy_ms() - middle};
}

void measure(bench::Report& report, const std::string& name, const geometry::Shape& shape, int frames, bool large) {
    const double start = busy_ms();
    test::ShadeRig rig(shape);
    report.add(name + ": triangles", static_cast<double>(shape.indices.size() / 3), "");
    report.add(name + ": mesh built once", busy_ms() - start, "ms");
    // From nothing and one more degree alternate, so that the machine's noise meets both.
    std::vector<double> anew, light, update, both, touched;
    for (int i = 0; i < frames; ++i) {
        if (i % (frames / 5 + 1) == 0) {
            rig.update.reset();
            const Frame first = frame(rig, turn * i - 0.5);
            anew.push_back(first.light_ms + first.update_ms);
        }
        const Frame next = frame(rig, turn * i);
        light.push_back(next.light_ms);
        update.push_back(next.update_ms);
        both.push_back(next.light_ms + next.update_ms);
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
    const Frame still = frame(rig, turn * (frames - 1));
    report.add_limited(name + ": cells swept when nothing moved", rig.update.stats.swept, "", 0.0);
    report.add(name + ": when nothing moved", still.light_ms + still.update_ms, "ms");
}

/// Cost by the cells touched: turns of the light of growing size.
void measure_turns(bench::Report& report, const geometry::Shape& shape) {
    test::ShadeRig rig(shape);
    frame(rig, 0.0);
    double at = 0.0;
    for (const double step : {0.25, 1.0, 4.0, 16.0, 64.0}) {
        std::vector<double> ms, touched;
        for (int i = 0; i < 9; ++i) {
            ms.push_back(frame(rig, at += step).update_ms);
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
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_shade_strokes: error: %s\n", error.what());
        return 1;
    }
}
