#include <hachure/runtime/assert.h>
#include <hachure/systems/implicit_brush/stamp_job.h>

#include <fmt/format.h>

#include <array>

namespace hachure {
namespace {

gpu::ProgramSource program_source(const StampJob& job) {
    gpu::ProgramSource source{.vertex = "common/full_screen.vert", .fragment = "implicit_brush/stamps.frag"};
    source.defines.push_back({"LEAST_SPREAD", fmt::format("{:.3f}", least_spread)});
    const auto define = [&](bool wanted, const char* name) {
        if (wanted) source.defines.push_back({name, ""});
    };
    define(job.contours, "CONTOURS");
    define(job.object_id != 0, "OWNERS");
    define(job.color != 0, "SURFACE_COLOR");
    define(job.noise != 0, "NOISE");
    return source;
}

} // namespace

void StampMaker::run(RenderContext& render, const StampJob& job) {
    HACHURE_ASSERT(job.style && job.profile && job.data && job.place && job.ink, "a brush has stamps of a feature");
    if (!style_) style_ = gpu::Buffer(sizeof(BrushStyle), gpu::BufferUsage::dynamic, "brush style");
    style_.update(std::span(job.style, 1));
    style_.bind_base(gpu::BufferBinding::uniform, 2);
    gpu::Program& program = render.shaders->program(program_source(job));
    if (job.object_id) {
        if (owners_.bytes() != job.owners.size_bytes())
            owners_ = gpu::Buffer(job.owners.size_bytes(), gpu::BufferUsage::dynamic, "brush owners");
        owners_.update(job.owners);
        owners_.bind_base(gpu::BufferBinding::storage, 0);
        program.set("owner_words", static_cast<std::uint32_t>(job.owner_words));
        program.set("owner_bit", static_cast<std::uint32_t>(job.owner_bit));
    }
    const std::array<std::uint32_t, 6> textures{job.profile, job.data, job.depth, job.object_id, job.color, job.noise};
    for (std::size_t unit = 0; unit < textures.size(); ++unit)
        if (textures[unit]) render.backend->texture(textures[unit]).bind(static_cast<unsigned>(unit));
    const gpu::Framebuffer& targets = render.backend->framebuffer({job.place, job.ink});
    targets.bind();
    gpu::apply({.viewport = {0, 0, targets.width(), targets.height()}, .scissor = job.rect});
    targets.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    targets.clear_color(1, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    program.use();
    render.full_screen.draw();
}

} // namespace hachure
