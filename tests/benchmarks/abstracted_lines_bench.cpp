// What finding abstracted lines costs against one full-screen pass of nine fetches, with bunny in view and beside it,
// and how accurate the qualities are. `--chart FILE [--quick]` writes what abstracted_lines_chart.gp draws.

#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/abstracted_lines_case.h>
#include <hachure/tests/benchmarks/abstracted_lines_chart.h>
#include <hachure/tests/benchmarks/abstracted_lines_front.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace hachure;

const std::array qualities = {bench::Finding{"fast", {.quality = ToneQuality::fast}},
                              bench::Finding{"standard", {.quality = ToneQuality::standard}},
                              bench::Finding{"accurate", {.quality = ToneQuality::accurate}}};

void report_cost(bench::Report& report, RenderContext& render, const bench::SceneTones& tones, bool quick) {
    for (const bench::Finding& finding : qualities) {
        const std::string name = finding.name;
        const bench::Cost cost = bench::cost_of(render, finding, tones, quick ? 1 : 21);
        report.add(name + ": blur", cost.blur_ms, "ms");
        report.add(name + ": lines", cost.lines_ms, "ms");
        report.add(name + ": one pass of 9 fetches", cost.floor_ms, "ms");
        const double ratio = cost.ms() / cost.floor_ms;
        if (finding.quality.quality == ToneQuality::accurate)
            report.add(name + ": blur and lines / pass of 9 fetches", ratio, "ratio");
        else
            report.add_limited(name + ": blur and lines / pass of 9 fetches", ratio, "ratio", 5.0);
    }
    const gpu::Rect& lines = tones.rects.lines;
    report.add("pixels that lines can be in",
               100.0 * lines.width * lines.height / (double(tones.diffuse.width) * double(tones.diffuse.height)), "%");
}

void report_frames(bench::Report& report, gpu::Context& context, RenderContext& render, const bench::SceneTones& tones,
                   const bench::Arguments& arguments) {
    const double floor = bench::cost_of(render, qualities[1], tones, arguments.quick ? 1 : 11).floor_ms;
    const bench::FrameCost cost =
        bench::frame_cost(context, arguments.model, qualities[1].quality, arguments.quick ? 2 : 15, arguments.quick);
    report.add("standard: added to a frame, tone image and all", cost.in_view, "ms");
    report.add("standard: added to a frame / pass of 9 fetches", cost.in_view / floor, "ratio");
    report.add_limited("standard: added to an empty frame / pass of 9 fetches", cost.beside / floor, "ratio", 1.3);
}

void report_accuracy(bench::Report& report, RenderContext& render, bool quick) {
    const std::vector<double> widths =
        quick ? std::vector{3.0} : std::vector{2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0};
    for (const bench::Finding& finding : qualities)
        for (const double contrast : {1.0, 0.03}) {
            const bench::Accuracy found = bench::accuracy_of(render, finding, widths, contrast, quick ? 2 : 16);
            const std::string name = std::string(finding.name) + (contrast < 0.5 ? ", contrast .03" : ", contrast 1");
            if (finding.quality.quality == ToneQuality::fast) {
                report.add(name + ": place, RMS", found.rms, "px");
                report.add(name + ": pixels lost", 1.0 - found.recall, "");
                report.add(name + ": pixels wrongly drawn", 1.0 - found.precision, "");
                continue;
            }
            report.add_limited(name + ": place, RMS", found.rms, "px", 0.02);
            report.add_limited(name + ": pixels lost", 1.0 - found.recall, "", 0.005);
            report.add_limited(name + ": pixels wrongly drawn", 1.0 - found.precision, "", 0.005);
            report.add_limited(name + ": width off by", found.band, "ratio", 0.05);
        }
}

/// No choice of the knobs is cheaper than a preset and as accurate.
void report_front(bench::Report& report, gpu::Context& context, RenderContext& render, const bench::SceneTones& tones,
                  bool quick) {
    bench::LineMeter meter(context, render, tones, quick);
    const std::vector<bench::Choice> choices = bench::measured_choices(meter);
    for (std::size_t i = 0; i < bench::presets().size(); ++i) {
        const bench::Choice& preset = choices[i];
        report.add(preset.name + ": tone image, blur and lines", preset.ms, "ms/Mpx");
        report.add(preset.name + ": place, RMS", preset.place, "px");
        report.add(preset.name + ": place of bars as they are drawn, RMS", preset.drawn, "px");
        int better = 0;
        for (const bench::Choice& other : choices) {
            if (!other.beats(preset)) continue;
            ++better;
            report.add("  cheaper, and as accurate: " + other.name, other.ms, "ms/Mpx");
        }
        report.add_limited(preset.name + ": cheaper choices that are as accurate", better, "", 0.0);
    }
}

int run(int argc, char** argv) {
    if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
        bench::write_abstracted_lines_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
        return 0;
    }
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "Cost and accuracy of abstracted lines, for bunny at 1024x768.");
    bench::Report report(arguments);
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    const bench::SceneTones tones = bench::scene_tones(*context, arguments.model, arguments.quick);
    RenderContext render(*context);
    report_cost(report, render, tones, arguments.quick);
    report_frames(report, *context, render, tones, arguments);
    report_accuracy(report, render, arguments.quick);
    report_front(report, *context, render, tones, arguments.quick);
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_abstracted_lines: error: %s\n", error.what());
        return 1;
    }
}
