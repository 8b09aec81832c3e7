#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/implicit_brush/feature_quality.h>
#include <hachure/systems/implicit_brush/field_pass.h>
#include <hachure/systems/implicit_brush/slope_diffusion.h>
#include <hachure/systems/implicit_brush/slope_passes.h>

#include <fmt/format.h>

namespace hachure {
namespace {

using gpu::TextureHandle;

struct ReliefPass {
    TextureHandle depth_buffer, normals, picture_depth, picture_normals, slopes;
};

struct MeanPass {
    TextureHandle fine, slopes;
};

struct TonePass {
    TextureHandle color, depth_buffer, picture_tone, tones;
};

struct ToneSlopePass {
    TextureHandle tones, insulation, slopes;
};

struct DiffusionPass {
    TextureHandle from, depth_buffer, scratch, to;
};

/// Declares the reading of a texture that may not be there.
TextureHandle read_named(gpu::FrameGraph& graph, gpu::PassBuilder& pass, const char* name) {
    const TextureHandle found = graph.find(name);
    return found ? pass.read(found) : found;
}

std::uint32_t id_of(const gpu::PassContext& pass, TextureHandle handle) { return handle ? pass.texture(handle) : 0; }

void depend_on(gpu::PassBuilder& pass, const RenderContext& render, const gpu::Rect& rect) {
    pass.depends_on(render.shaders->generation());
    pass.draws_in(rect);
}

gpu::TextureDesc slope_desc(const World& world, const FeatureImage& quality) {
    const View& view = world.resource<View>();
    return {view.width, view.height, feature_format(quality.storage)};
}

/// The pixels that pictures take.
gpu::Rect picture_rect(const World& world) {
    gpu::Rect all;
    if (const PictureList* pictures = world.find_resource<PictureList>())
        for (const PictureItem& item : pictures->items) all = united(all, item.rect);
    return all;
}

bool has_pictures(const World& world) {
    const PictureList* pictures = world.find_resource<PictureList>();
    return pictures && !pictures->items.empty();
}

} // namespace

bool has_relief(const World& world) {
    const gpu::FrameGraph& graph = world.resource<RenderContext>().graph;
    return !world.resource<DrawList>().items.empty() || (graph.find("picture_depth") && graph.find("picture_normal"));
}

bool is_drawn_alone(const World& world) {
    const gpu::FrameGraph& graph = world.resource<RenderContext>().graph;
    return !(graph.find("picture_depth") && graph.find("picture_normal"));
}

/// What another renderer made has no samples.
SlopePasses::SlopePasses(World& world, const FeatureImage& quality, const gpu::Rect& rect)
    : world_(world), quality_(quality), rect_(rect), samples_(is_drawn_alone(world) ? quality.samples : 1) {}

TextureHandle SlopePasses::made(SlopeKind kind, int steps, float half_break) const {
    for (const Made& m : made_)
        if (m.kind == kind && m.steps == steps && m.half_break == half_break) return m.texture;
    return {};
}

TextureHandle SlopePasses::slopes(SlopeKind kind, int steps) {
    constexpr float insulating = SlopeJob{}.half_break;
    if (const TextureHandle texture = made(kind, steps, insulating)) return texture;
    const TextureHandle texture = steps > 0                      ? declare_diffusion(kind, steps)
                                  : kind == SlopeKind::luminance ? declare_tone_slopes()
                                                                 : declare_relief(kind, insulating);
    made_.push_back({kind, steps, insulating, texture});
    return texture;
}

TextureHandle SlopePasses::breaks(float half_break) {
    if (const TextureHandle texture = made(SlopeKind::breaks, 0, half_break)) return texture;
    const TextureHandle texture = declare_relief(SlopeKind::breaks, half_break);
    made_.push_back({SlopeKind::breaks, 0, half_break, texture});
    return texture;
}

TextureHandle SlopePasses::declare_relief(SlopeKind kind, float half_break) {
    RenderContext& render = world_.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    if (samples_ > 1 && !fine_surface_)
        fine_surface_ =
            declare_fine_surface(world_, {.pass = "brush_fine", .samples = samples_, .rect = rect_, .normals = true});
    const std::string kind_name =
        kind == SlopeKind::surface ? std::string("brush_slope") : fmt::format("brush_breaks_{}", half_break);
    const std::string name = samples_ > 1 ? kind_name + "_fine" : kind_name;
    const gpu::Rect rect = fine_rect(rect_, samples_);
    const int samples = samples_;
    const ReliefPass& made = graph.add_pass<ReliefPass>(
        name,
        [&](gpu::PassBuilder& pass, ReliefPass& data) {
            data.depth_buffer = pass.read(fine_surface_ ? fine_surface_->depth_buffer : graph.find("depth_buffer"));
            data.normals = pass.read(fine_surface_ ? fine_surface_->normals : graph.find("normal"));
            data.picture_depth = read_named(graph, pass, "picture_depth");
            data.picture_normals = read_named(graph, pass, "picture_normal");
            const View fine = fine_view(world_.resource<View>(), samples);
            data.slopes = pass.create(name, {fine.width, fine.height, feature_format(quality_.storage)});
            depend_on(pass, render, rect);
            pass.depends_on(world_.resource<View>().key());
        },
        [&world = world_, &render, kind, half_break, rect, samples](const ReliefPass& data, gpu::PassContext& pass) {
            render.view_uniforms.bind(fine_view(world.resource<View>(), samples), world.resource<LightList>());
            SlopeJob{.kind = kind,
                     .depth_buffer = pass.texture(data.depth_buffer),
                     .normals = pass.texture(data.normals),
                     .picture_depth = id_of(pass, data.picture_depth),
                     .picture_normals = id_of(pass, data.picture_normals),
                     .half_break = half_break * static_cast<float>(samples),
                     .rect = rect,
                     .to = pass.texture(data.slopes)}
                .run(render);
        });
    return samples > 1 ? declare_mean(kind, kind_name, made.slopes) : made.slopes;
}

TextureHandle SlopePasses::declare_mean(SlopeKind kind, const std::string& name, TextureHandle fine) {
    RenderContext& render = world_.resource_mutable<RenderContext>();
    const gpu::Rect rect = rect_;
    const MeanPass& made = render.graph.add_pass<MeanPass>(
        name,
        [&](gpu::PassBuilder& pass, MeanPass& data) {
            data.fine = pass.read(fine);
            data.slopes = pass.create(name, slope_desc(world_, quality_));
            depend_on(pass, render, rect);
        },
        [&render, kind, rect](const MeanPass& data, gpu::PassContext& pass) {
            gpu::ProgramSource source = field_program("implicit_brush/mean_slope.frag");
            if (kind == SlopeKind::breaks) source.defines.push_back({"BREAKS", ""});
            draw_field(render, render.shaders->program(source), {rect}, pass.texture(data.slopes),
                       {pass.texture(data.fine)});
        });
    return made.slopes;
}

/// What is seen as tones: of pictures their own, without the steps of a colour buffer, of surfaces that of their
/// colour.
TextureHandle SlopePasses::declare_tones() {
    RenderContext& render = world_.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const gpu::Rect rect = rect_, pictures = picture_rect(world_);
    const TonePass& made = graph.add_pass<TonePass>(
        "brush_tone",
        [&](gpu::PassBuilder& pass, TonePass& data) {
            data.color = pass.read(graph.find("color"));
            data.depth_buffer = pass.read(graph.find("depth_buffer"));
            if (has_pictures(world_)) data.picture_tone = read_named(graph, pass, "picture_tone");
            const View& view = world_.resource<View>();
            data.tones = pass.create("brush_tone", {view.width, view.height, gpu::Format::rg32f});
            depend_on(pass, render, rect);
            pass.depends_on(pictures);
        },
        [&render, rect, pictures](const TonePass& data, gpu::PassContext& pass) {
            gpu::ProgramSource source = field_program("implicit_brush/tone.frag");
            if (data.picture_tone) source.defines.push_back({"PICTURES", ""});
            gpu::Program& program = render.shaders->program(source);
            program.set("pictures", glm::ivec4(pictures.x, pictures.y, pictures.x + pictures.width - 1,
                                               pictures.y + pictures.height - 1));
            draw_field(render, program, {rect}, pass.texture(data.tones),
                       {pass.texture(data.color), pass.texture(data.depth_buffer), id_of(pass, data.picture_tone)});
        });
    return made.tones;
}

TextureHandle SlopePasses::declare_tone_slopes() {
    RenderContext& render = world_.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const TextureHandle tones = declare_tones();
    const TextureHandle surface = has_relief(world_) ? slopes(SlopeKind::surface, 0) : TextureHandle{};
    const gpu::Rect rect = rect_;
    const ToneSlopePass& made = graph.add_pass<ToneSlopePass>(
        "brush_tone_slope",
        [&](gpu::PassBuilder& pass, ToneSlopePass& data) {
            data.tones = pass.read(tones);
            if (surface) data.insulation = pass.read(surface);
            data.slopes = pass.create("brush_tone_slope", slope_desc(world_, quality_));
            depend_on(pass, render, rect);
        },
        [&render, rect](const ToneSlopePass& data, gpu::PassContext& pass) {
            SlopeJob{.kind = SlopeKind::luminance,
                     .tones = pass.texture(data.tones),
                     .insulation = id_of(pass, data.insulation),
                     .rect = rect,
                     .to = pass.texture(data.slopes)}
                .run(render);
        });
    return made.slopes;
}

TextureHandle SlopePasses::declare_diffusion(SlopeKind kind, int steps) {
    RenderContext& render = world_.resource_mutable<RenderContext>();
    const TextureHandle from = slopes(kind, 0);
    const bool masked = kind == SlopeKind::surface && is_drawn_alone(world_);
    const std::string name =
        fmt::format("brush_{}_{}", kind == SlopeKind::luminance ? "tone_diffusion" : "diffusion", steps);
    const gpu::Rect rect = rect_;
    const DiffusionPass& made = render.graph.add_pass<DiffusionPass>(
        name,
        [&](gpu::PassBuilder& pass, DiffusionPass& data) {
            data.from = pass.read(from);
            if (masked) data.depth_buffer = pass.read(render.graph.find("depth_buffer"));
            const gpu::TextureDesc desc = slope_desc(world_, quality_);
            data.scratch = pass.create(name + "_scratch", desc);
            data.to = pass.create(name, desc);
            depend_on(pass, render, rect);
        },
        [&render, rect, steps](const DiffusionPass& data, gpu::PassContext& pass) {
            SlopeDiffusionJob{.steps = steps,
                              .from = pass.texture(data.from),
                              .to = pass.texture(data.to),
                              .scratch = pass.texture(data.scratch),
                              .rect = rect,
                              .depth_buffer = id_of(pass, data.depth_buffer)}
                .run(render);
        });
    return made.to;
}

} // namespace hachure
