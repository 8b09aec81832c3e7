#include <hachure/runtime/error.h>
#include <hachure/systems/abstracted_lines/tone_quality.h>
#include <hachure/tests/benchmarks/abstracted_lines_chart.h>
#include <hachure/tests/benchmarks/abstracted_lines_front.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

namespace hachure::bench {
namespace {

ToneImage custom(ToneImage quality) {
    quality.quality = ToneQuality::custom;
    return quality;
}

/// The file, and what its points are measured by.
class Chart {
public:
    Chart(const std::filesystem::path& path, bool quick)
        : path_(path), context_(gpu::make_context()), tones_(scene_tones(*context_, {}, quick)), render_(*context_),
          meter_(*context_, render_, tones_, quick), file_(path) {
        file_ << "panel,series,label,x,y\n";
    }

    LineMeter& meter() { return meter_; }

    void write(std::string_view panel, std::string_view series, const std::string& label, double x, double y) {
        file_ << fmt::format("{},{},{},{},{}\n", panel, series, label, x, y) << std::flush;
    }

    void finish() {
        if (!file_.flush()) throw Error(path_.string(), "the file could not be written");
    }

private:
    std::filesystem::path path_;
    std::unique_ptr<gpu::Context> context_;
    SceneTones tones_;
    RenderContext render_;
    LineMeter meter_;
    std::ofstream file_;
};

/// Taps and fits; and, with what the tone image costs, samples: the presets in both.
void search_and_samples_panels(Chart& chart) {
    LineMeter& meter = chart.meter();
    std::vector<Finding> findings = presets();
    const std::size_t shipped = findings.size();
    for (const Finding& knob : knobs())
        if (knob.quality.blur == ToneImage{}.blur && knob.quality.storage == ToneImage{}.storage)
            findings.push_back(knob);
    const std::vector<Cost> costs = meter.costs(findings);
    for (std::size_t i = 0; i < findings.size(); ++i) {
        Finding finding = findings[i];
        finding.quality = resolved(finding.quality);
        const bool preset = i < shipped;
        const std::string label = preset ? finding.name : std::to_string(finding.quality.iterations);
        chart.write("search", preset ? "preset" : finding.name, label, costs[i].ms(), meter.place(finding));
        if (preset)
            chart.write("samples", "preset", label, meter.tone_ms(finding.quality.samples) + costs[i].ms(),
                        meter.drawn(finding).rms());
        if (i != 1) continue; // the standard with other numbers of samples
        for (const int samples : meter.samples()) {
            finding.quality.samples = samples;
            const double ms = meter.tone_ms(samples) + costs[i].ms();
            const test::LineScore thin = meter.drawn(finding, 0.5);
            chart.write("samples", "wide", std::to_string(samples), ms, meter.drawn(finding).rms());
            chart.write("samples", "thin", fmt::format("{}: {:.0f} % seen", samples, 100.0 * thin.recall()), ms,
                        thin.rms());
        }
    }
}

/// Kinds of blur: their time and place, and what lines do when the picture moves by a pixel.
void blur_and_moved_panels(Chart& chart) {
    struct Kind {
        const char* name;
        ToneBlur blur;
    };
    std::vector<Finding> findings;
    for (const Kind& kind : {Kind{"exact", ToneBlur::exact},
                             {"separable", ToneBlur::separable},
                             {"recursive", ToneBlur::recursive},
                             {"half", ToneBlur::half},
                             {"kawase", ToneBlur::kawase}})
        for (const double width : {4.0, 8.0, 16.0, 24.0})
            if (kind.blur != ToneBlur::exact || width <= 8.0) // else minutes
                findings.push_back({kind.name, custom({.blur = kind.blur, .iterations = 6}), width});
    const std::vector<Cost> costs = chart.meter().costs(findings);
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& finding = findings[i];
        const std::string label = fmt::format("{}", finding.width);
        chart.write("blur", finding.name, label, costs[i].blur_ms, chart.meter().place(finding, {finding.width}, 1.0));
        // A logarithmic axis has no 0: what does not change at all is drawn at its foot.
        chart.write("moved", finding.name, label, costs[i].blur_ms,
                    std::max(chart.meter().change_when_moved(finding), 0.01));
    }
}

void storage_panel(Chart& chart) {
    const std::vector<Finding> findings = {{"rg8", custom({.storage = ToneStorage::rg8})},
                                           {"rg16", custom({.storage = ToneStorage::rg16})},
                                           {"rg16f", custom({.storage = ToneStorage::rg16f})},
                                           {"rg32f", custom({.storage = ToneStorage::rg32f})}};
    const std::vector<Cost> costs = chart.meter().costs(findings);
    for (std::size_t i = 0; i < findings.size(); ++i)
        for (const double contrast : {1.0, 0.1, 0.03})
            chart.write("storage", findings[i].name, fmt::format("{}", contrast), costs[i].ms(),
                        chart.meter().place(findings[i], {4.0, 16.0}, contrast));
}

/// What is left of edges, and of bars; and what it costs.
void beta_panel(Chart& chart) {
    std::vector<Finding> findings;
    for (const float beta : {0.0f, 0.05f, 0.1f, 0.15f, 0.2f, 0.25f, 0.3f, 0.4f, 0.5f, 0.7f, 1.0f})
        findings.push_back({"beta", {}, 4.0, beta});
    const std::vector<Cost> costs = chart.meter().costs(findings);
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& finding = findings[i];
        const double beta = static_cast<double>(finding.beta);
        for (const double contrast : {1.0, 0.3}) {
            const LineMeter::EdgeWidth width = chart.meter().edge_width(finding, contrast);
            chart.write("beta", fmt::format("edge {}", contrast), "", beta, width.found);
            chart.write("beta", fmt::format("paper {}", contrast), "", beta, width.paper);
        }
        chart.write("beta", "bar", "", beta, chart.meter().bar_width(finding));
        chart.write("beta", "ms", "", beta, costs[i].ms());
    }
}

} // namespace

void write_abstracted_lines_chart(const std::filesystem::path& path, bool quick) {
    Chart chart(path, quick);
    search_and_samples_panels(chart);
    blur_and_moved_panels(chart);
    storage_panel(chart);
    beta_panel(chart);
    chart.finish();
}

} // namespace hachure::bench
