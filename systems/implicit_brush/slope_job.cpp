#include <hachure/runtime/assert.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/field_pass.h>
#include <hachure/systems/implicit_brush/slope_job.h>

namespace hachure {
namespace {

void run_tone_slope(RenderContext& render, const SlopeJob& job) {
    gpu::ProgramSource source = field_program("implicit_brush/tone_slope.frag");
    if (job.insulation) source.defines.push_back({"INSULATED", ""});
    gpu::Program& program = render.shaders->program(source);
    draw_field(render, program, {job.rect}, job.to, {job.tones, job.insulation});
}

} // namespace

void SlopeJob::run(RenderContext& render) const {
    if (kind == SlopeKind::luminance) return run_tone_slope(render, *this);
    HACHURE_ASSERT(depth_buffer && normals, "slopes of surfaces are those of depth and normals");
    gpu::ProgramSource source = field_program("implicit_brush/slope.frag");
    if (kind == SlopeKind::breaks) source.defines.push_back({"BREAKS", ""});
    if (picture_depth && picture_normals) source.defines.push_back({"PICTURE", ""});
    gpu::Program& program = render.shaders->program(source);
    program.set("half_break", half_break);
    // Breaks are beside a surface, too, and a picture's are where the depth buffer is empty.
    const bool masked = kind == SlopeKind::surface && !picture_depth;
    draw_field(render, program, {rect, masked ? depth_buffer : 0}, to,
               {depth_buffer, normals, picture_depth, picture_normals});
}

} // namespace hachure
