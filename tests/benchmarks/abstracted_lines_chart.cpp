#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/abstracted_lines_case.h>
#include <hachure/tests/benchmarks/abstracted_lines_chart.h>

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

/// Measures one point after the other into a file.
class Chart {
public:
    Chart(const std::filesystem::path& path, bool quick)
        : path_(path), quick_(quick), context_(gpu::make_context()), tones_(scene_tones(*context_, {}, quick)),
          render_(*context_), file_(path) {
        file_ << "panel,series,label,x,y\n";
        const gpu::Rect& lines = tones_.rects.lines;
        megapixels_ = 1e-6 * lines.width * lines.height;
    }

    /// The ms of a megapixel that lines can be in. Others may slow the machine down for a while: times are taken over
    /// that of the pass of nine fetches beside them, and that pass counts as it did at first.
    double ms_per_megapixel(const Finding& finding, bool blur_alone = false) {
        const Cost cost = cost_of(render_, finding, tones_, quick_ ? 1 : 5);
        if (floor_ms_ <= 0.0) floor_ms_ = cost.floor_ms;
        return (blur_alone ? cost.blur_ms : cost.ms()) / cost.floor_ms * floor_ms_ / megapixels_;
    }

    double rms(const Finding& finding, const std::vector<double>& widths, double contrast = 1.0) {
        return accuracy_of(render_, finding, widths, contrast, quick_ ? 2 : 12).rms;
    }

    void write(std::string_view panel, std::string_view series, const std::string& label, double x, double y) {
        file_ << fmt::format("{},{},{},{},{}\n", panel, series, label, x, std::max(y, 1e-4)) << std::flush;
    }

    void finish() {
        if (!file_.flush()) throw Error(path_.string(), "the file could not be written");
    }

private:
    std::filesystem::path path_;
    bool quick_;
    std::unique_ptr<gpu::Context> context_;
    SceneTones tones_;
    RenderContext render_;
    std::ofstream file_;
    double megapixels_ = 1.0;
    double floor_ms_ = 0.0; ///< of the first measurement
};

const std::vector<double> all_widths = {3.0, 4.0, 8.0, 16.0};

void search_panel(Chart& chart) {
    struct Taps {
        const char* name;
        ToneTaps taps;
    };
    for (const Taps& taps :
         {Taps{"square", ToneTaps::square}, {"weighted", ToneTaps::weighted}, {"wide", ToneTaps::wide}})
        for (int iterations = 1; iterations <= 8; ++iterations) {
            const Finding finding{taps.name, custom({.taps = taps.taps, .iterations = iterations})};
            chart.write("search", taps.name, std::to_string(iterations), chart.ms_per_megapixel(finding),
                        chart.rms(finding, all_widths));
        }
    for (const auto& [name, quality] : {std::pair{"standard", ToneQuality::standard},
                                        {"fast", ToneQuality::fast},
                                        {"accurate", ToneQuality::accurate}}) {
        const Finding finding{name, {.quality = quality}};
        chart.write("search", "preset", name, chart.ms_per_megapixel(finding), chart.rms(finding, all_widths));
    }
}

void blur_panel(Chart& chart) {
    struct Kind {
        const char* name;
        ToneBlur blur;
    };
    for (const Kind& kind : {Kind{"exact", ToneBlur::exact},
                             {"separable", ToneBlur::separable},
                             {"recursive", ToneBlur::recursive},
                             {"half", ToneBlur::half},
                             {"kawase", ToneBlur::kawase}})
        for (const double width : {4.0, 8.0, 16.0, 24.0}) {
            if (kind.blur == ToneBlur::exact && width > 8.0) continue; // minutes
            const Finding finding{kind.name, custom({.blur = kind.blur, .iterations = 6}), width};
            chart.write("blur", kind.name, fmt::format("{}", width), chart.ms_per_megapixel(finding, true),
                        chart.rms(finding, {width}));
        }
}

void storage_panel(Chart& chart) {
    struct Storage {
        const char* name;
        ToneStorage storage;
    };
    for (const Storage& storage : {Storage{"rg8", ToneStorage::rg8},
                                   {"rg16", ToneStorage::rg16},
                                   {"rg16f", ToneStorage::rg16f},
                                   {"rg32f", ToneStorage::rg32f}})
        for (const double contrast : {1.0, 0.1, 0.03}) {
            const Finding finding{storage.name, custom({.storage = storage.storage, .iterations = 6})};
            chart.write("storage", storage.name, fmt::format("{}", contrast), chart.ms_per_megapixel(finding),
                        chart.rms(finding, {4.0, 16.0}, contrast));
        }
}

/// What a part of the way costs in accuracy, along the number of fits.
void beta_panel(Chart& chart) {
    for (const int iterations : {1, 2, 3, 5, 8})
        for (const float beta : {0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.7f, 1.0f}) {
            const Finding finding{"beta", custom({.iterations = iterations}), 4.0, beta};
            chart.write("beta", std::to_string(iterations), fmt::format("{:.2f}", beta), static_cast<double>(beta),
                        chart.rms(finding, all_widths));
        }
}

} // namespace

void write_abstracted_lines_chart(const std::filesystem::path& path, bool quick) {
    Chart chart(path, quick);
    search_panel(chart);
    blur_panel(chart);
    storage_panel(chart);
    beta_panel(chart);
    chart.finish();
}

} // namespace hachure::bench
