#include <hachure/runtime/assert.h>
#include <hachure/systems/implicit_brush/feature_profile.h>
#include <hachure/systems/implicit_brush/field_pass.h>

#include <algorithm>
#include <array>
#include <string>

namespace hachure {
namespace {

glm::ivec4 area_of(const gpu::Rect& rect) {
    return {rect.x, rect.y, rect.x + rect.width - 1, rect.y + rect.height - 1};
}

/// The depths that pixels are marked with.
constexpr float plain_mark = 0.5f, singular_mark = 1.0f;

void mark_candidates(RenderContext& render, const FeatureProfileJob& job, gpu::DrawState state) {
    gpu::Program& program = render.shaders->program(field_program("implicit_brush/profile_marks.frag"));
    const float window = job.window.world_depth ? job.reach : job.window.length;
    program.set("area", area_of(job.valid));
    program.set("least_height", 0.95f * job.least_height);
    program.set("reach", std::min({job.reach, window, 32.0f}));
    program.set("most_singular", 0.5f * job.most_singular);
    state.depth_test = gpu::DepthTest::always;
    state.depth_write = true;
    state.color_write = {false, false, false, false};
    gpu::apply(state);
    program.use();
    render.full_screen.draw();
}

void find_profiles(RenderContext& render, const FeatureProfileJob& job, gpu::DrawState state, bool singular) {
    gpu::ProgramSource source{.vertex = "common/marked.vert", .fragment = "implicit_brush/profile.frag"};
    source.defines = {{"TAPS", std::to_string(job.taps)}, {"FITS", std::to_string(job.fits)}};
    if (job.window.world_depth) source.defines.push_back({"WORLD_WINDOW", ""});
    if (singular) source.defines.push_back({"JUNCTIONS", ""});
    gpu::Program& program = render.shaders->program(source);
    program.set("area", area_of(job.valid));
    program.set("window", job.window.length);
    program.set("most_singular", job.most_singular);
    program.set("depth", singular ? singular_mark : plain_mark);
    if (job.window.world_depth) render.backend->texture(job.window.world_depth).bind(2);
    state.depth_test = gpu::DepthTest::equal;
    gpu::apply(state);
    program.use();
    render.full_screen.draw();
}

} // namespace

void FeatureProfileJob::run(RenderContext& render) const {
    HACHURE_ASSERT(taps >= 2 && fits >= 1, "a cubic takes four samples");
    const gpu::Framebuffer& target = render.backend->framebuffer({to}, candidates);
    target.bind();
    const gpu::DrawState state{.viewport = {0, 0, target.width(), target.height()}, .scissor = rect};
    gpu::DrawState clearing = state;
    clearing.depth_test = gpu::DepthTest::always;
    clearing.depth_write = true;
    gpu::apply(clearing);
    target.clear_color(0, std::array{1e4f, 1e4f, 0.0f, 0.0f});
    target.clear_depth(0.0f);
    render.backend->texture(data).bind(0);
    mark_candidates(render, *this, state);
    for (const bool singular : {false, true}) find_profiles(render, *this, state, singular);
}

} // namespace hachure
