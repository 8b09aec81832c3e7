#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/gl.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/convolution_plan.h>
#include <hachure/systems/implicit_brush/stamp_convolver.h>
#include <hachure/systems/implicit_brush/tip_textures.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>

namespace hachure {
namespace {

constexpr int plan_group = 256, list_group = 64, sum_group = 32;

/// Texture units, as the shaders have them.
enum Unit : GLuint { places_unit, inks_unit, marks_unit, list_unit, tiles_unit, canvas_unit, bitmap_unit };

glm::ivec2 first_of(const gpu::Rect& rect) { return {rect.x, rect.y}; }
glm::ivec2 last_of(const gpu::Rect& rect) { return {rect.x + rect.width - 1, rect.y + rect.height - 1}; }

/// The texels of marks that those pixels are in.
gpu::Rect mark_area(const gpu::Rect& pixels) {
    const int left = pixels.x / 32, right = (pixels.x + pixels.width - 1) / 32;
    return {left, pixels.y, right - left + 1, pixels.height};
}

void barrier(GLbitfield what) { gpu::gl().MemoryBarrier(what); }

void draw_indirect(std::size_t command) {
    gpu::gl().DrawArraysIndirect(GL_TRIANGLES, reinterpret_cast<const void*>(command));
}

void dispatch_indirect(std::size_t groups) { gpu::gl().DispatchComputeIndirect(static_cast<GLintptr>(groups)); }

/// What sums in whole numbers count 1 as: as much as leaves room for the largest sum there can be, of stamps that lie
/// at least half as dense as pixels do, times colours up to 16.
float fixed_point(const ConvolveJob& job) {
    const double largest = double(job.largest_radius) + 2.0, crowded = 1.0 + double(job.largest_shift) / largest;
    // Of stamps that reach a pixel, those at a distance d have at least that radius, and count radius / d times.
    const double sum = 2.0 * std::numbers::pi * double(job.radius) * (largest + 4.0) * crowded * crowded;
    return static_cast<float>(double(1 << 30) / (sum * (job.sums_opacity() ? 1.0 : 16.0)));
}

} // namespace

/// One run, and its textures by what they are for.
struct StampConvolver::Run {
    RenderContext& render;
    const ConvolveJob& job;
    std::uint32_t marks, starts, reached, tiles, list = 0, splat_sums = 0, running_sums = 0;
    int width, height, reach;
    gpu::Rect painted;

    Run(RenderContext& render_, const ConvolveJob& job_, std::span<const std::uint32_t> scratch)
        : render(render_), job(job_), marks(scratch[0]), starts(scratch[1]), reached(scratch[2]), tiles(scratch[3]) {
        if (scratch.size() > 4) list = scratch[4];
        if (job.may_use(BrushMethod::splat)) splat_sums = scratch[5];
        if (job.may_use(BrushMethod::sums)) running_sums = scratch.back();
        const gpu::TextureDesc& desc = texture(job.inks).desc();
        width = desc.width;
        height = desc.height;
        reach = job.reach();
        painted = job.painted(width, height);
    }

    [[nodiscard]] gpu::Texture& texture(std::uint32_t id) const { return render.backend->texture(id); }

    /// What every shader that includes stamp.glsl depends on.
    [[nodiscard]] std::vector<gpu::ShaderDefine> defines() const {
        std::vector<gpu::ShaderDefine> defines = job.footprint.defines();
        if (job.same_place) defines.push_back({"SAME_PLACE", ""});
        if (job.sums_opacity()) defines.push_back({"SAME_COLOR", ""});
        return defines;
    }

    /// A program with the stamps and their form.
    gpu::Program& stamping(gpu::ProgramSource source) const {
        const std::vector<gpu::ShaderDefine> form = defines();
        source.defines.insert(source.defines.end(), form.begin(), form.end());
        gpu::Program& program = render.shaders->program(source);
        program.set("aspect", job.footprint.aspect);
        program.set("nominal_radius", job.radius);
        program.set("largest_radius", job.largest_radius);
        if (job.same_place) program.set("same_place", *job.same_place);
        program.set("first", first_of(job.stamps));
        program.set("last", last_of(job.stamps));
        program.set("reach", reach);
        program.set("picture", glm::vec2(width, height));
        if (!job.same_place) texture(job.places).bind(places_unit);
        texture(job.inks).bind(inks_unit);
        if (job.bitmap != nullptr) {
            program.set("tip_colored", job.bitmap->colored);
            job.bitmap->texture.bind(bitmap_unit);
        }
        return program;
    }

    /// One that also turns sums into ink.
    gpu::Program& toning(gpu::ProgramSource source) const {
        const bool canvas = job.canvas.texture != 0 && job.canvas.amount > 0.0f;
        if (canvas) source.defines.push_back({"CANVAS", ""});
        source.defines.push_back({"TILE", std::to_string(convolution_tile)});
        gpu::Program& program = stamping(std::move(source));
        program.set("white", static_cast<float>(job.footprint.mass(double(job.radius)) * double(job.peak)));
        program.set("contrast", job.contrast);
        program.set("opacity", job.opacity);
        if (job.sums_opacity()) program.set("same_color", *job.same_color);
        if (!canvas) return program;
        program.set("canvas", job.canvas.amount);
        program.set("canvas_channel", job.canvas.channel);
        texture(job.canvas.texture).bind(canvas_unit);
        return program;
    }

    /// Draws from now on go into `into`, within the part that gets ink.
    void draw_into(std::uint32_t into, gpu::Blend blend) const {
        const gpu::Framebuffer& framebuffer = render.backend->framebuffer({into});
        framebuffer.bind();
        gpu::apply({.viewport = {0, 0, width, height}, .scissor = painted, .blend = blend});
    }

    /// Draws into all of a small texture, or a part of it.
    void fill(std::uint32_t into, const gpu::Rect& rect) const {
        const gpu::Framebuffer& framebuffer = render.backend->framebuffer({into});
        framebuffer.bind();
        gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
        render.full_screen.draw();
    }
};

void StampConvolver::run(RenderContext& render, const ConvolveJob& job, std::span<const std::uint32_t> scratch) {
    HACHURE_ASSERT(job.places != 0 || job.same_place, "stamps have places");
    HACHURE_ASSERT(job.footprint.tip != BrushTip::bitmap || job.bitmap != nullptr, "a bitmap tip has a bitmap");
    HACHURE_ASSERT(scratch.size() == job.scratch(1, 1).size(), "as many textures as the job asked for");
    if (!plan_) {
        plan_ = gpu::Buffer(sizeof(ConvolutionPlan), gpu::BufferUsage::immutable, "convolution plan");
        vertex_array_ = gpu::VertexArray("convolution");
    }
    const bool chosen = !job.may_use(job.method) || job.method == BrushMethod::automatic;
    if (chosen && !cost_) cost_ = context_cost(render);
    const Run run(render, job, scratch);
    if (run.painted.width <= 0 || run.painted.height <= 0) return plan_.clear();
    mark(run);
    plan(run);
    plan_.bind(GL_DRAW_INDIRECT_BUFFER);
    plan_.bind(GL_DISPATCH_INDIRECT_BUFFER);
    if (run.list != 0) list(run);
    if (job.may_use(BrushMethod::splat)) splat(run);
    if (job.may_use(BrushMethod::sums)) sum(run);
    if (job.may_use(BrushMethod::gather)) gather(run, false);
    if (job.may_use(BrushMethod::tiles)) gather(run, true);
}

/// Marks the pixels that stamp, and counts those near each tile.
void StampConvolver::mark(const Run& run) const {
    gpu::Program& marks = run.stamping({.vertex = "common/full_screen.vert", .fragment = "implicit_brush/marks.frag"});
    marks.use();
    run.fill(run.marks, mark_area(run.job.stamps));

    gpu::Program& reached = run.render.shaders->program({.vertex = "common/full_screen.vert",
                                                         .fragment = "implicit_brush/reached.frag",
                                                         .defines = {{"TILE", std::to_string(convolution_tile)}}});
    reached.set("first", first_of(run.job.stamps));
    reached.set("last", last_of(run.job.stamps));
    reached.set("reach", run.reach);
    run.texture(run.marks).bind(marks_unit);
    reached.use();
    run.fill(run.reached, {0, 0, tiles_of(run.width), tiles_of(run.height)});
}

void StampConvolver::plan(const Run& run) {
    const gpu::Rect area = mark_area(run.job.stamps);
    gpu::Program& program = run.render.shaders->program({.compute = "implicit_brush/plan.comp",
                                                         .defines = {{"GROUP", std::to_string(plan_group)},
                                                                     {"LIST_GROUP", std::to_string(list_group)},
                                                                     {"SUM_GROUP", std::to_string(sum_group)}}});
    program.set("mark_area", glm::ivec4(area.x, area.y, area.width, area.height));
    program.set("sum_rows", (run.job.sums_opacity() ? 1 : 4) * run.painted.height);
    const bool forced = run.job.may_use(run.job.method) && run.job.method != BrushMethod::automatic;
    program.set("forced", forced ? static_cast<int>(run.job.method) : 0);
    if (!forced) cost_->prices(run.job, run.width, run.height).set(program);
    plan_.bind_base(gpu::BufferBinding::storage, 0);
    run.texture(run.marks).bind(marks_unit);
    run.texture(run.reached).bind(list_unit);
    run.texture(run.starts).bind_image(0, GL_WRITE_ONLY);
    run.texture(run.tiles).bind_image(1, GL_WRITE_ONLY);
    program.use();
    gpu::gl().DispatchCompute(1, 1, 1);
    barrier(GL_COMMAND_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/// Draws two triangles over each tile that stamps reach, if the plan has them.
void StampConvolver::draw_tiles(const Run& run, std::size_t command) const {
    run.texture(run.tiles).bind(tiles_unit);
    vertex_array_.bind();
    draw_indirect(command);
}

/// Lists the stamps, if the plan wants them listed.
void StampConvolver::list(const Run& run) const {
    const gpu::Rect area = mark_area(run.job.stamps);
    gpu::Program& list = run.render.shaders->program(
        {.compute = "implicit_brush/list.comp", .defines = {{"LIST_GROUP", std::to_string(list_group)}}});
    list.set("mark_area", glm::ivec4(area.x, area.y, area.width, area.height));
    run.texture(run.marks).bind(marks_unit);
    run.texture(run.starts).bind(list_unit);
    run.texture(run.list).bind_image(0, GL_WRITE_ONLY);
    list.use();
    dispatch_indirect(offsetof(ConvolutionPlan, list_groups));
    barrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Stamps into sums, and sums into ink.
void StampConvolver::splat(const Run& run) const {
    run.draw_into(run.splat_sums, gpu::Blend::off);
    gpu::Program& clear = run.render.shaders->program({.vertex = "implicit_brush/tile.vert",
                                                       .fragment = "implicit_brush/clear.frag",
                                                       .defines = {{"TILE", std::to_string(convolution_tile)}}});
    clear.set("picture", glm::vec2(run.width, run.height));
    clear.use();
    draw_tiles(run, offsetof(ConvolutionPlan, splat_tiles));

    gpu::Program& splats =
        run.stamping({.vertex = "implicit_brush/splat.vert", .fragment = "implicit_brush/splat.frag"});
    run.texture(run.list).bind(list_unit);
    run.draw_into(run.splat_sums, gpu::Blend::add);
    splats.use();
    vertex_array_.bind();
    draw_indirect(offsetof(ConvolutionPlan, splats));

    gpu::Program& resolve =
        run.toning({.vertex = "implicit_brush/tile.vert", .fragment = "implicit_brush/resolve.frag"});
    run.texture(run.splat_sums).bind(marks_unit);
    run.draw_into(run.job.target, gpu::Blend::premultiplied);
    resolve.use();
    draw_tiles(run, offsetof(ConvolutionPlan, splat_tiles));
}

/// Where disks begin and end; sums of that, and ink from those.
void StampConvolver::sum(const Run& run) const {
    const int channels = run.job.sums_opacity() ? 1 : 4;
    const gpu::Rect& painted = run.painted;
    const glm::ivec4 corners(painted.x, painted.y, last_of(painted));
    const gpu::Texture& sums = run.texture(run.running_sums);
    clear_sums(run, {channels * painted.x, painted.y, channels * painted.width, painted.height});

    gpu::Program& edges =
        run.stamping({.compute = "implicit_brush/edges.comp", .defines = {{"GROUP", std::to_string(sum_group)}}});
    edges.set("painted", corners);
    edges.set("fixed_point", fixed_point(run.job));
    run.texture(run.list).bind(list_unit);
    sums.bind_image(0, GL_READ_WRITE);
    edges.use();
    dispatch_indirect(offsetof(ConvolutionPlan, edge_groups));
    barrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);

    gpu::Program& running = run.render.shaders->program(
        {.compute = "implicit_brush/running_sums.comp",
         .defines = {{"GROUP", std::to_string(sum_group)}, {"CHANNELS", std::to_string(channels)}}});
    running.set("painted", corners);
    running.use();
    dispatch_indirect(offsetof(ConvolutionPlan, sum_groups));
    barrier(GL_TEXTURE_FETCH_BARRIER_BIT);

    gpu::Program& ink = run.toning({.vertex = "implicit_brush/tile.vert", .fragment = "implicit_brush/sums.frag"});
    ink.set("fixed_point", fixed_point(run.job));
    sums.bind(marks_unit);
    run.draw_into(run.job.target, gpu::Blend::premultiplied);
    ink.use();
    draw_tiles(run, offsetof(ConvolutionPlan, sum_tiles));
}

void StampConvolver::clear_sums(const Run& run, const gpu::Rect& texels) const {
    const gpu::Framebuffer& framebuffer = run.render.backend->framebuffer({run.running_sums});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = texels});
    run.render.shaders->program({.vertex = "common/full_screen.vert", .fragment = "implicit_brush/clear_sums.frag"})
        .use();
    vertex_array_.bind();
    draw_indirect(offsetof(ConvolutionPlan, sum_clear));
    barrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

/// Ink in one step: each pixel adds up what reaches it.
void StampConvolver::gather(const Run& run, bool marked) const {
    gpu::ProgramSource source{.vertex = "implicit_brush/tile.vert", .fragment = "implicit_brush/gather.frag"};
    if (marked) source.defines = {{"MARKED", ""}, {"BLOCK", std::to_string(gather_block)}};
    gpu::Program& program = run.toning(std::move(source));
    run.texture(run.marks).bind(marks_unit);
    run.draw_into(run.job.target, gpu::Blend::premultiplied);
    program.use();
    draw_tiles(run, marked ? offsetof(ConvolutionPlan, marked_tiles) : offsetof(ConvolutionPlan, gather_tiles));
}

ConvolutionCounts StampConvolver::counts() const {
    ConvolutionPlan plan{};
    plan_.read(std::span(&plan, 1));
    return {static_cast<BrushMethod>(plan.method), plan.stamp_count, plan.tile_count, plan.pair_count};
}

} // namespace hachure
