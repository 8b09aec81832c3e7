#pragma once

#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/tests/benchmarks/abstracted_lines_case.h>
#include <hachure/tests/support/line_images.h>
#include <hachure/tests/support/line_score.h>

#include <vector>

namespace hachure::bench {

/// Dark bars on white as surfaces of a scene, drawn by the renderer with a number of samples of a pixel, at many angles
/// and sub-pixel places: what the samples keep of where they are.
class DrawnBars {
public:
    /// `width` of the bars, and the width of lines they are looked for with, px.
    DrawnBars(gpu::Context& context, int samples, double width, double line_width, int angles);

    /// What a finding makes of them: the truth are pixels up to half a bar away, half a pixel at least.
    [[nodiscard]] test::LineScore score(RenderContext& render, const Finding& finding) const;

private:
    struct Bar {
        test::TrueLine line;
        test::Tones tones;
    };
    double width_, line_width_;
    int size_;
    std::vector<Bar> bars_;
};

/// Of the numbers of samples that tones can have, 1, 2 and 4, those that this device has.
[[nodiscard]] std::vector<int> offered_samples(const gpu::Context& context);

} // namespace hachure::bench
