#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/brush_noise_job.h>

#include <algorithm>
#include <string>

namespace hachure {
namespace {

/// Grains below a pixel would be no grains but flicker.
constexpr float least_pixels = 1.0f;

gpu::ProgramSource program_source(const BrushNoiseJob& job) {
    gpu::ProgramSource source{.vertex = "common/full_screen.vert", .fragment = "implicit_brush/noise.frag"};
    source.defines.push_back({"GRAIN", std::to_string(static_cast<int>(job.key.grain))});
    if (job.key.world_size) source.defines.push_back({"WORLD_SIZE", ""});
    if (job.places != 0) source.defines.push_back({"PLACES", ""});
    return source;
}

} // namespace

void BrushNoiseJob::run(RenderContext& render) const {
    if (rect.width <= 0 || rect.height <= 0) return;
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({to});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
    gpu::Program& program = render.shaders->program(program_source(*this));
    program.set("size", key.world_size ? key.size : std::max(key.size, least_pixels));
    program.set("reference_pixel", 2.0f / picture_height);
    program.set("flatness", key.flatness);
    program.set("seed", key.seed);
    if (places != 0) {
        render.backend->texture(places).bind(0);
        render.backend->texture(objects).bind(1);
    }
    if (key.grain == BrushGrain::advected)
        for (GLuint k = 0; k < 2; ++k) render.backend->texture(pasts[k]).bind(2 + k);
    program.use();
    render.full_screen.draw();
}

} // namespace hachure
