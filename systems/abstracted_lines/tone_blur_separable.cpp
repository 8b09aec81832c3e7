#include <hachure/systems/abstracted_lines/tone_blur_kinds.h>
#include <hachure/systems/abstracted_lines/tone_levels.h>

#include <string>

namespace hachure {
namespace {

gpu::Program& gaussian(RenderContext& render, gpu::ProgramSource& source, const char* fragment, double sigma) {
    const std::vector<float> weights = blur_weights(sigma);
    source = {.vertex = "common/full_screen.vert",
              .fragment = fragment,
              .defines = {{"RADIUS", std::to_string(weights.size() - 1)}}};
    gpu::Program& program = render.shaders->program(source);
    program.set("weights", std::span<const float>(weights));
    return program;
}

void blur_along(RenderContext& render, const BlurDraw& step, glm::ivec2 along, double sigma) {
    gpu::ProgramSource source;
    gaussian(render, source, "abstracted_lines/blur.frag", sigma).set("along", along);
    step.fetched(render, source);
}

} // namespace

void blur_separable(RenderContext& render, const ToneBlurJob& job, std::uint32_t between) {
    const gpu::Rect tall = grown(job.rect, 0, blur_radius(job.sigma), job.valid);
    blur_along(render, {job.from, between, job.valid, tall}, {1, 0}, job.sigma);
    blur_along(render, {between, job.to, tall, job.rect}, {0, 1}, job.sigma);
}

void blur_exact(RenderContext& render, const ToneBlurJob& job) {
    gpu::ProgramSource source;
    (void)gaussian(render, source, "abstracted_lines/blur_exact.frag", job.sigma);
    BlurDraw{job.from, job.to, job.valid, job.rect}.fetched(render, source);
}

} // namespace hachure
