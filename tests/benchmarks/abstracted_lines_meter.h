#pragma once

#include <hachure/tests/benchmarks/abstracted_lines_case.h>
#include <hachure/tests/benchmarks/abstracted_lines_drawn_bars.h>

#include <map>
#include <vector>

namespace hachure::bench {

/// Measures findings: ms by megapixel that lines can be in, and how far off they are.
class LineMeter {
public:
    /// What is passed must outlive it. `quick`: once, and few lines.
    LineMeter(gpu::Context& context, RenderContext& render, const SceneTones& tones, bool quick);

    /// In turns. Others may slow the machine down for a while: times are taken over that of a pass of nine fetches
    /// among them, and that pass counts as it did at first.
    [[nodiscard]] std::vector<Cost> costs(const std::vector<Finding>& findings);

    /// What the tone image itself costs with that many samples, of those that are offered.
    [[nodiscard]] double tone_ms(int samples) const { return tone_ms_.at(samples); }
    [[nodiscard]] std::vector<int> samples() const;

    /// RMS, px, on exact bars as wide as the lines are, of several widths, of full contrast and of .03.
    [[nodiscard]] double place(const Finding& finding);
    /// The same for these alone.
    [[nodiscard]] double place(const Finding& finding, const std::vector<double>& widths, double contrast);
    /// On bars as the renderer draws them with the samples of the finding: as wide as lines of 4 px, or half a pixel.
    [[nodiscard]] test::LineScore drawn(const Finding& finding, double bar_width = 4.0);

    /// The width of the line along an edge of tones over the width asked for.
    struct EdgeWidth {
        double found = 0.0;
        double paper = 0.0; ///< by the paper's search in double precision
    };
    [[nodiscard]] EdgeWidth edge_width(const Finding& finding, double contrast);
    /// The width of the line along a bar over the width asked for.
    [[nodiscard]] double bar_width(const Finding& finding);

    /// By how much opacities change, at most, where a picture moves by one pixel and they with it: of 255.
    [[nodiscard]] double change_when_moved(const Finding& finding);

private:
    int angles() const { return quick_ ? 2 : 12; }

    gpu::Context& context_;
    RenderContext& render_;
    const SceneTones& tones_;
    bool quick_;
    double megapixels_ = 1.0, floor_ms_ = 0.0;
    std::map<int, double> tone_ms_;
    std::map<std::pair<int, double>, DrawnBars> drawn_;
};

} // namespace hachure::bench
