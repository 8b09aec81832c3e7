#include <hachure/systems/abstracted_lines/tone_blur_kinds.h>
#include <hachure/systems/abstracted_lines/tone_levels.h>

#include <string>

namespace hachure {
namespace {

gpu::Program& gaussian(RenderContext& render, gpu::ProgramSource& source, double sigma) {
    const std::vector<float> weights = blur_weights(sigma);
    source.defines.push_back({"RADIUS", std::to_string(weights.size() - 1)});
    gpu::Program& program = render.shaders->program(source);
    program.set("weights", std::span<const float>(weights));
    return program;
}

enum class Axis { rows, columns };

void blur_along(RenderContext& render, const BlurDraw& step, Axis axis, double sigma) {
    const bool widths = render.backend->texture(step.from).channels() == 4;
    gpu::ProgramSource source{.vertex = "common/full_screen.vert",
                              .fragment = "abstracted_lines/blur.frag",
                              .defines = {{"AXIS", axis == Axis::rows ? "0" : "1"}, {"CHANNELS", widths ? "4" : "2"}}};
    (void)gaussian(render, source, sigma);
    step.fetched(render, source);
}

} // namespace

void blur_separable(RenderContext& render, const ToneBlurJob& job, std::uint32_t between) {
    const gpu::Rect tall = grown(job.rect, 0, blur_radius(job.sigma), job.valid);
    blur_along(render, {job.from, between, job.valid, tall}, Axis::rows, job.sigma);
    blur_along(render, {between, job.to, tall, job.rect}, Axis::columns, job.sigma);
}

void blur_exact(RenderContext& render, const ToneBlurJob& job) {
    gpu::ProgramSource source{.vertex = "common/full_screen.vert", .fragment = "abstracted_lines/blur_exact.frag"};
    (void)gaussian(render, source, job.sigma);
    BlurDraw{job.from, job.to, job.valid, job.rect}.fetched(render, source);
}

} // namespace hachure
