#include <hachure/systems/implicit_brush/feature_data.h>
#include <hachure/systems/implicit_brush/field_pass.h>
#include <hachure/systems/implicit_brush/widen_job.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hachure {
namespace {

/// What a straight contour along an axis, with breaks of 1 between two rows of pixels, is at its highest: each of the
/// two rows has a gradient of 1, and a Gaussian of all variance there is smooths them.
float contour_peak(int reach) {
    const double variance = 0.5 + 0.5 * reach;
    return static_cast<float>(2.0 / std::sqrt(2.0 * std::numbers::pi * (variance + 0.25)));
}

int reach_of(const FeatureDataJob& job) {
    return contour_reach(job.window.world_depth ? middling_contour_window : job.window.length);
}

/// The smoothed tensor of contours.
void run_contours(RenderContext& render, const FeatureDataJob& job) {
    draw_field(render, render.shaders->program(field_program("implicit_brush/contour_tensor.frag")), {job.rect},
               job.scratch, {job.slopes});
    WidenJob{reach_of(job), job.scratch, job.scratch_2, job.to, job.rect}.run(render);
}

} // namespace

int contour_reach(float window) { return std::clamp(static_cast<int>(std::lround(window)), 2, 16); }

void FeatureDataJob::run(RenderContext& render) const {
    const bool contours = feature == BrushFeature::contours;
    if (contours) run_contours(render, *this);
    gpu::ProgramSource source = field_program("implicit_brush/feature.frag");
    source.defines = {{"FEATURE", std::to_string(static_cast<int>(feature))}};
    if (luminance) source.defines.push_back({"LUMINANCE", ""});
    if (window.world_depth) source.defines.push_back({"WORLD_WINDOW", ""});
    gpu::Program& program = render.shaders->program(source);
    program.set("window", window.length);
    if (contours) program.set("peak", contour_peak(reach_of(*this)));
    draw_field(render, program, {rect, depth_buffer}, scratch, {contours ? scratch_2 : slopes, 0, window.world_depth});
    draw_field(render, render.shaders->program(field_program("implicit_brush/singularity.frag")), {rect, depth_buffer},
               to, {scratch});
}

} // namespace hachure
