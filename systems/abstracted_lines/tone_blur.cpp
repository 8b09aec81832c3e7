#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/tone_blur.h>
#include <hachure/systems/abstracted_lines/tone_levels.h>

#include <algorithm>
#include <string>

namespace hachure {
namespace {

/// A rectangle that is larger by `margin` above and below, within `limit`.
gpu::Rect taller(const gpu::Rect& rect, int margin, const gpu::Rect& limit) {
    const int low = std::max(rect.y - margin, limit.y);
    const int high = std::min(rect.y + rect.height + margin, limit.y + limit.height);
    return {rect.x, low, rect.width, high - low};
}

/// One direction of a separable blur.
struct LinePass {
    std::uint32_t from, to;
    gpu::Rect valid, rect;
    glm::ivec2 along;
};

void blur_along(RenderContext& render, const LinePass& pass, double sigma) {
    const std::vector<float> weights = blur_weights(sigma);
    gpu::Program& program = render.shaders->program({.vertex = "common/full_screen.vert",
                                                     .fragment = "abstracted_lines/blur.frag",
                                                     .defines = {{"RADIUS", std::to_string(weights.size() - 1)}}});
    program.set("weights", std::span<const float>(weights));
    program.set("along", pass.along);
    program.set("first", glm::ivec2(pass.valid.x, pass.valid.y));
    program.set("last", glm::ivec2(pass.valid.x + pass.valid.width - 1, pass.valid.y + pass.valid.height - 1));
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({pass.to});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = pass.rect});
    render.backend->texture(pass.from).bind(0);
    program.use();
    render.full_screen.draw();
}

void blur_separable(RenderContext& render, const ToneBlurJob& job, std::uint32_t rows) {
    const gpu::Rect tall = taller(job.rect, blur_radius(job.sigma), job.valid);
    blur_along(render, {job.from, rows, job.valid, tall, {1, 0}}, job.sigma);
    blur_along(render, {rows, job.to, tall, job.rect, {0, 1}}, job.sigma);
}

} // namespace

std::vector<gpu::TextureDesc> ToneBlurJob::scratch(ToneBlur, double, const gpu::TextureDesc& desc) { return {desc}; }

void ToneBlurJob::run(RenderContext& render, std::span<const std::uint32_t> scratch) const {
    blur_separable(render, *this, scratch[0]);
}

} // namespace hachure
