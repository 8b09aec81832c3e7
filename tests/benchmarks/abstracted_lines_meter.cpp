#include <hachure/tests/benchmarks/abstracted_lines_meter.h>
#include <hachure/tests/support/line_finding.h>
#include <hachure/tests/support/tone_ridge_reference.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hachure::bench {
namespace {

constexpr double opaque_from = 0.013; ///< where opacity is a half: between the thresholds of the default look

/// Lines of the default look, as sharp as pixels allow.
AbstractedLines sharp_lines(const Finding& finding) {
    AbstractedLines lines;
    lines.width = static_cast<float>(finding.width), lines.beta = finding.beta;
    lines.fade = lines.counterchange = 0.0f;
    return lines;
}

/// Pixels of the dark line along an edge, as the paper finds them.
double paper_pixels(const test::Tones& edge, const test::TrueLine& line, const Finding& finding, int rim) {
    const test::RidgeSearch search{
        .width = finding.width, .beta = static_cast<double>(finding.beta), .iterations = 5, .guard = 0.0025};
    const test::Tones blurred = test::blurred(edge, search.deviation());
    const test::BilinearTone tone{blurred};
    test::LineFit fit(tone, search);
    double drawn = 0.0;
    for (int y = rim; y < edge.height - rim; ++y)
        for (int x = rim; x < edge.width - rim; ++x) {
            const glm::dvec2 pixel = test::pixel_center(x, y);
            if (std::abs(line.distance(pixel)) > 3.0 * finding.width) continue;
            const test::FoundLine found = test::search_line(fit, search, pixel);
            drawn += found.drawn(finding.width) && found.curvature >= opaque_from ? 1.0 : 0.0;
        }
    return drawn;
}

} // namespace

LineMeter::LineMeter(gpu::Context& context, RenderContext& render, const SceneTones& tones, bool quick)
    : context_(context), render_(render), tones_(tones), quick_(quick),
      megapixels_(1e-6 * tones.rects.lines.width * tones.rects.lines.height) {
    const std::vector<int> samples = offered_samples(context);
    const std::vector<double> ms = tone_costs(context, samples, quick ? 1 : 9, quick);
    for (std::size_t i = 0; i < samples.size(); ++i) tone_ms_[samples[i]] = ms[i] / megapixels_;
}

std::vector<Cost> LineMeter::costs(const std::vector<Finding>& findings) {
    std::vector<Cost> costs = costs_of(render_, findings, tones_, quick_ ? 1 : 7);
    if (floor_ms_ <= 0.0) floor_ms_ = costs.front().floor_ms;
    for (Cost& cost : costs) {
        const double scale = floor_ms_ / cost.floor_ms / megapixels_;
        cost.blur_ms *= scale, cost.lines_ms *= scale, cost.floor_ms *= scale;
    }
    return costs;
}

std::vector<int> LineMeter::samples() const {
    std::vector<int> counts;
    for (const auto& [samples, ms] : tone_ms_) counts.push_back(samples);
    return counts;
}

double LineMeter::place(const Finding& finding) {
    const std::vector<double> widths = quick_ ? std::vector{4.0} : std::vector{3.0, 4.0, 8.0, 16.0};
    return std::hypot(place(finding, widths, 1.0), place(finding, widths, 0.03)) / std::numbers::sqrt2;
}

double LineMeter::place(const Finding& finding, const std::vector<double>& widths, double contrast) {
    return accuracy_of(render_, finding, widths, contrast, angles()).rms;
}

test::LineScore LineMeter::drawn(const Finding& finding, double bar_width) {
    const int samples = resolved(finding.quality).samples;
    const auto [bars, made] = drawn_.try_emplace({samples, bar_width}, context_, samples, bar_width, 4.0, 2 * angles());
    return bars->second.score(render_, finding);
}

LineMeter::EdgeWidth LineMeter::edge_width(const Finding& finding, double contrast) {
    const int size = 2 * static_cast<int>(6.0 * finding.width), rim = size / 4;
    test::LineFinding search(render_, sharp_lines(finding), finding.quality, size, size);
    EdgeWidth width;
    double length = 0.0;
    for (int k = 0; k < angles(); ++k) {
        const auto edge =
            test::TrueLine::through_middle(size, size, std::numbers::pi * (k + 0.3) / angles(), test::spread_phase(k));
        const test::Tones tones =
            test::draw_line(size, size, edge, test::profile::Step{}, 0.5 - 0.5 * contrast, contrast);
        const std::vector<test::PixelLine> found = search.find(tones);
        for (int y = rim; y < size - rim; ++y)
            for (int x = rim; x < size - rim; ++x) {
                width.found += found[static_cast<std::size_t>(y * size + x)].dark >= 0.5 ? 1.0 : 0.0;
                // Pixels within one of the edge are as many as it is long, twice.
                length += std::abs(edge.distance(test::pixel_center(x, y))) < 1.0 ? 0.5 : 0.0;
            }
        width.paper += paper_pixels(tones, edge, finding, rim);
    }
    width.found /= length * finding.width, width.paper /= length * finding.width;
    return width;
}

double LineMeter::bar_width(const Finding& finding) {
    const Accuracy accuracy = accuracy_of(render_, finding, {finding.width}, 1.0, angles());
    return 1.0 - accuracy.band;
}

double LineMeter::change_when_moved(const Finding& finding) {
    const int rim = static_cast<int>(8.0 * finding.width), size = 2 * rim + 64;
    test::Tones tones(size, size), moved = tones;
    for (int y = rim; y < size - rim; ++y)
        for (int x = rim; x < size - rim; ++x)
            tones.at(x, y) = moved.at(x + 1, y) =
                0.5 + 0.2 * test::normal_noise(5, static_cast<std::uint64_t>(y * size + x / 3));
    AbstractedLines lines;
    lines.width = static_cast<float>(finding.width), lines.beta = finding.beta;
    test::LineFinding search(render_, lines, finding.quality, size, size);
    const std::vector<test::PixelLine> a = search.find(tones), b = search.find(moved);
    double most = 0.0;
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
        if ((i + 1) % static_cast<std::size_t>(size) != 0)
            most = std::max({most, std::abs(a[i].dark - b[i + 1].dark), std::abs(a[i].highlight - b[i + 1].highlight)});
    return 255.0 * most;
}

} // namespace hachure::bench
