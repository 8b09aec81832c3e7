#include <hachure/runtime/gpu/gl.h>
#include <hachure/systems/implicit_brush/feature_quality.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/implicit_brush_feature_chart.h>
#include <hachure/tests/support/ripple_relief.h>

#include <fmt/format.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace hachure::bench {
namespace {

namespace ripple = test::ripple;

constexpr double ripple_curvature = 0.1; // 1/px at the top of the first ring

/// A relief whose curvature is the ripple, with slopes that are off by a normal deviation.
test::SlopeImage curved_relief(double noise) {
    const ripple::Integral integral(60.0);
    test::SlopeImage made =
        ripple::relief([&](double r) { return -ripple_curvature * ripple::scale * integral.once(r); });
    for (std::size_t i = 0; i < made.texels.size(); ++i)
        if (i % 4 < 2) made.texels[i] += static_cast<float>(noise * test::normal_noise(5, i));
    return made;
}

/// Lines of a feature of that relief.
std::vector<test::TrueCircle> true_circles(BrushFeature feature, double window) {
    if (feature == BrushFeature::ridges)
        return ripple::scaled(ripple::circles([](double r) { return ripple::h(r); }, window),
                              ripple_curvature * window);
    // Mean curvature, whose change makes inflections, is half of that along the radius and half of that around.
    const ripple::Integral integral(60.0);
    const auto change = [&](double r) {
        return std::abs(0.5 * (ripple::derivative(1, r) + ripple::h(r) / r - integral.once(r) / (r * r)));
    };
    return ripple::scaled(ripple::circles(change, window), ripple_curvature * window * window / ripple::scale);
}

/// ms of each step, per megapixel.
struct StepTimes {
    double diffusion = 0.0, data = 0.0, profiles = 0.0;
    [[nodiscard]] double all() const { return diffusion + data + profiles; }
};

template <class Work> double ms_of(int rounds, const Work& work) {
    std::vector<double> times;
    for (int i = -1; i < rounds; ++i) { // the first one compiles shaders
        gpu::gl().Finish();
        const double start = now_ms();
        work();
        gpu::gl().Finish();
        if (i >= 0) times.push_back(now_ms() - start);
    }
    return median(times);
}

class FeatureRows {
public:
    FeatureRows(std::ostream& file, RenderContext& render, bool quick)
        : file_(file), render_(render), rounds_(quick ? 1 : 9) {}

    void window(double noise) {
        for (const float window : {2.0f, 3.0f, 4.0f, 6.0f, 8.0f, 12.0f})
            add("window", noise_name(noise), fmt::format("{}", window), {.diffusion = 2, .window = window, .fits = 3},
                noise, &StepTimes::profiles);
    }
    void taps(int fits) {
        for (const int taps : {2, 3, 4, 6, 8, 12})
            add("taps", fmt::format("{} fits", fits), fmt::format("{}", taps), {.taps = taps, .fits = fits}, 0.0,
                &StepTimes::profiles);
    }
    void preset(const char* name, FeatureQuality quality) {
        const FeatureImage image = resolved({.quality = quality});
        add("taps", "preset", name, {.taps = image.taps, .fits = image.fits, .storage = feature_format(image.storage)},
            0.0, &StepTimes::profiles);
    }
    void diffusion(double noise) {
        for (const int steps : {0, 1, 2, 4, 8, 16, 32})
            add("diffusion", noise_name(noise), fmt::format("{}", steps), {.diffusion = steps, .fits = 3}, noise,
                &StepTimes::diffusion);
    }
    void storage(BrushFeature feature, const char* series) {
        for (const auto& [name, format] :
             {std::pair{"16", gpu::Format::rgba16f}, std::pair{"32", gpu::Format::rgba32f}})
            add("storage", series, name, {.feature = feature, .diffusion = 2, .fits = 3, .storage = format}, 0.0,
                nullptr);
    }

private:
    static std::string noise_name(double noise) { return fmt::format("noise {}", noise); }

    /// One point; its time is that of `step`, or of all.
    void add(const std::string& panel, const std::string& series, const std::string& label,
             const test::FeatureSettings& settings, double noise, double StepTimes::*step) {
        test::FeatureFinding finding(render_, settings, ripple::size, ripple::size);
        finding.upload(curved_relief(noise));
        StepTimes ms;
        if (settings.diffusion > 0) ms.diffusion = ms_of(rounds_, [&] { finding.diffuse(); });
        ms.data = ms_of(rounds_, [&] { finding.extract(); });
        ms.profiles = ms_of(rounds_, [&] { finding.profile(); });
        const auto window = static_cast<double>(settings.window);
        const double error = ripple::score(finding.profiles(), true_circles(settings.feature, window)).rms_of_all();
        constexpr double megapixels = 1e-6 * ripple::size * ripple::size;
        file_ << fmt::format("{},{},{},{},{}\n", panel, series, label, (step ? ms.*step : ms.all()) / megapixels, error)
              << std::flush;
    }

    std::ostream& file_;
    RenderContext& render_;
    int rounds_;
};

} // namespace

void write_feature_rows(std::ostream& file, gpu::Context& context, bool quick) {
    RenderContext render(context);
    FeatureRows rows(file, render, quick);
    const std::vector<double> noises = quick ? std::vector{0.01} : std::vector{0.0, 0.005, 0.02};
    for (const double noise : noises) rows.window(noise);
    for (const int fits : quick ? std::vector{2} : std::vector{1, 2, 3, 4}) rows.taps(fits);
    rows.preset("fast", FeatureQuality::fast);
    rows.preset("standard", FeatureQuality::standard);
    rows.preset("accurate", FeatureQuality::accurate);
    for (const double noise : noises) rows.diffusion(noise);
    rows.storage(BrushFeature::ridges, "ridges");
    rows.storage(BrushFeature::inflections, "inflections");
}

} // namespace hachure::bench
