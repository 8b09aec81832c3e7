#include <hachure/systems/abstracted_lines/tone_quality.h>
#include <hachure/tests/benchmarks/abstracted_lines_front.h>

#include <fmt/format.h>

namespace hachure::bench {

std::vector<Finding> presets() {
    return {{"fast", {.quality = ToneQuality::fast}},
            {"standard", {.quality = ToneQuality::standard}},
            {"accurate", {.quality = ToneQuality::accurate}}};
}

std::vector<Finding> knobs() {
    std::vector<Finding> all;
    const auto add = [&](const char* name, ToneImage quality) {
        quality.quality = ToneQuality::custom;
        all.push_back({name, quality});
    };
    for (int fits = 1; fits <= 8; ++fits) {
        add("square", {.taps = ToneTaps::square, .iterations = fits});
        add("weighted", {.taps = ToneTaps::weighted, .iterations = fits});
        add("wide", {.taps = ToneTaps::wide, .iterations = fits});
    }
    add("separable", {.blur = ToneBlur::separable});
    add("half", {.blur = ToneBlur::half});
    add("kawase", {.blur = ToneBlur::kawase});
    add("rg8", {.storage = ToneStorage::rg8});
    add("rg16f", {.storage = ToneStorage::rg16f});
    add("rg32f", {.storage = ToneStorage::rg32f});
    return all;
}

std::vector<Choice> measured_choices(LineMeter& meter) {
    std::vector<Finding> findings = presets();
    const std::size_t shipped = findings.size();
    for (const Finding& knob : knobs()) findings.push_back(knob);
    const std::vector<Cost> costs = meter.costs(findings);
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        Finding finding = findings[i];
        const ToneImage knobs = resolved(finding.quality);
        const double place = meter.place(finding);
        for (const int samples : i < shipped ? std::vector{knobs.samples} : meter.samples()) {
            finding.quality = knobs;
            finding.quality.samples = samples;
            choices.push_back({i < shipped
                                   ? std::string(finding.name)
                                   : fmt::format("{}, {} fits, {} samples", finding.name, knobs.iterations, samples),
                               meter.tone_ms(samples) + costs[i].ms(), place, meter.drawn(finding).rms()});
        }
    }
    return choices;
}

} // namespace hachure::bench
