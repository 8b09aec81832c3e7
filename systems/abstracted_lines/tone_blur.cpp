#include <hachure/systems/abstracted_lines/linear_sampling.h>
#include <hachure/systems/abstracted_lines/tone_blur_kinds.h>

namespace hachure {
namespace {

/// What is done for a kind: where its own way is no better, or cannot be had, the separable one.
ToneBlur done_for(ToneBlur kind, double sigma) {
    if (kind == ToneBlur::recursive && sigma < 1.0) return ToneBlur::separable; // steps of a stack: too small for poles
    if (kind == ToneBlur::half && halvings(sigma) == 0) return ToneBlur::separable;
    if (kind == ToneBlur::kawase && !fits_pyramid(sigma)) return ToneBlur::separable;
    return kind;
}

} // namespace

void BlurDraw::draw(RenderContext& render, gpu::Program& program) const {
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({to});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
    render.backend->texture(from).bind(0);
    program.use();
    render.full_screen.draw();
}

void BlurDraw::sampled(RenderContext& render, const char* fragment) const {
    gpu::Program& program = render.shaders->program({.vertex = "common/full_screen.vert", .fragment = fragment});
    program.set("first", glm::vec2(valid.x, valid.y) + 0.5f);
    program.set("last", glm::vec2(valid.x + valid.width, valid.y + valid.height) - 0.5f);
    const LinearSampling between_texels(render, from);
    draw(render, program);
}

void BlurDraw::fetched(RenderContext& render, const gpu::ProgramSource& source) const {
    gpu::Program& program = render.shaders->program(source);
    program.set("first", glm::ivec2(valid.x, valid.y));
    program.set("last", glm::ivec2(valid.x + valid.width - 1, valid.y + valid.height - 1));
    draw(render, program);
}

std::vector<gpu::TextureDesc> ToneBlurJob::scratch(ToneBlur kind, double sigma, const gpu::TextureDesc& desc) {
    switch (done_for(kind, sigma)) {
    case ToneBlur::exact:
        return {};
    case ToneBlur::recursive:
        return recursive_scratch(desc);
    case ToneBlur::half:
        return halved_scratch(sigma, desc);
    case ToneBlur::kawase:
        return kawase_scratch(sigma, desc);
    case ToneBlur::separable:
        break;
    }
    return {desc};
}

void ToneBlurJob::run(RenderContext& render, std::span<const std::uint32_t> scratch) const {
    if (rect.width <= 0 || rect.height <= 0) return;
    switch (done_for(kind, sigma)) {
    case ToneBlur::exact:
        return blur_exact(render, *this);
    case ToneBlur::recursive:
        return blur_recursive(render, *this, scratch);
    case ToneBlur::half:
        return blur_halved(render, *this, scratch);
    case ToneBlur::kawase:
        return blur_kawase(render, *this, scratch);
    case ToneBlur::separable:
        return blur_separable(render, *this, scratch[0]);
    }
}

} // namespace hachure
