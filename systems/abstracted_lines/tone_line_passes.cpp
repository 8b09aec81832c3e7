#include <hachure/components/abstracted_lines.h>
#include <hachure/components/tone_image.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/abstracted_lines/tone_blur.h>
#include <hachure/systems/abstracted_lines/tone_levels.h>
#include <hachure/systems/abstracted_lines/tone_line_passes.h>
#include <hachure/systems/abstracted_lines/tone_quality.h>

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace hachure {
namespace {

using gpu::TextureHandle;

/// White where nothing is drawn, without highlights, without a width of lines.
constexpr std::array background_tone{1.0f, 0.0f, 0.0f, 0.0f};

struct TonePass {
    TextureHandle tone, depth, samples, pictures;
};

struct SpecularPass {
    TextureHandle tone, specular;
};

struct BlurPass {
    TextureHandle tone;
    std::vector<TextureHandle> levels;
    std::vector<std::vector<TextureHandle>> scratch; ///< of each level
};

/// What finding lines reads, and what it draws into.
struct FindPass {
    std::vector<TextureHandle> levels, targets;
    std::array<TextureHandle, 2> found; ///< scratch
    TextureHandle object_ids;
    TextureHandle candidates; ///< depth that marks the pixels which are searched
    LineTarget lines;         ///< where lines are drawn, not told
};

std::uint64_t styles_key(const ToneLineFrame& frame) {
    gpu::KeyHash key;
    for (const ToneLineStyle& style : frame.styles)
        for (const glm::vec4& part : {style.color, style.highlight_color, style.thresholds, style.kinds, style.line})
            key.add(part);
    const ToneImage& quality = frame.quality;
    key.add(quality.samples);
    key.add(quality.storage);
    key.add(quality.blur);
    key.add(quality.taps);
    key.add(quality.iterations);
    key.add(frame.narrowest);
    key.add(frame.widest);
    key.add(frame.uniform);
    return key.value();
}

std::vector<double> widths_of(const ToneLineFrame& frame) {
    return stack_widths(double(frame.narrowest), double(frame.widest));
}

/// So that all of it can be cleared.
void bind_whole(const gpu::Framebuffer& framebuffer) {
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}});
}

/// The tones of pictures, behind all surfaces.
void draw_pictures(const World& world, RenderContext& render, std::uint32_t tones) {
    const ToneLineFrame& frame = world.resource<ToneLineFrame>();
    const View& view = world.resource<View>();
    constexpr const char* fragment = "abstracted_lines/picture_tone.frag";
    gpu::Program& program = render.shaders->program({.vertex = "common/full_screen.vert", .fragment = fragment});
    for (const PictureItem& item : world.resource<PictureList>().items) {
        const gpu::Rect rect = common(item.rect, frame.rects.shaded);
        if (rect.width <= 0 || rect.height <= 0) continue;
        const bool has_lines = item.object_id < frame.styles.size();
        program.set("width", has_lines ? frame.styles[item.object_id].line.x : 0.0f);
        render.draw_full_screen(fragment, {.viewport = {0, 0, view.width, view.height}, .scissor = rect}, {tones});
    }
}

/// Runs the search into a framebuffer of the targets of a pass.
void find_lines(World& world, const FindPass& data, gpu::PassContext& pass, LineFinder& finder,
                const gpu::Framebuffer& target, LineOutput output) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const ToneLineFrame& frame = world.resource<ToneLineFrame>();
    if (frame.rects.empty()) return;
    const std::vector<double> widths = widths_of(frame);
    std::vector<ToneLevel> levels;
    for (std::size_t i = 0; i < widths.size(); ++i) levels.push_back({pass.texture(data.levels[i]), widths[i]});
    finder.run(render, {.quality = frame.quality,
                        .levels = levels,
                        .widths = levels.back().texture,
                        .object_ids = data.object_ids ? pass.texture(data.object_ids) : 0,
                        .styles = data.object_ids ? std::span(frame.styles) : std::span(&frame.only, 1),
                        .width = frame.widest,
                        .least_curvature = frame.least_curvature,
                        .rect = frame.rects.lines,
                        .output = output,
                        .target = &target,
                        .found = {pass.texture(data.found[0]), pass.texture(data.found[1])},
                        .candidates = data.candidates ? pass.texture(data.candidates) : 0});
}

void declare_find(World& world, gpu::PassBuilder& pass, std::string_view name, const std::vector<TextureHandle>& levels,
                  bool owners, FindPass& data) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const ToneLineFrame& frame = world.resource<ToneLineFrame>();
    for (const TextureHandle level : levels) data.levels.push_back(pass.read(level));
    const gpu::TextureDesc& desc = render.graph.desc(levels.front());
    const gpu::TextureDesc found = LineFinder::found_desc(desc.width, desc.height);
    data.found = {pass.create(fmt::format("{}_found", name), found),
                  pass.create(fmt::format("{}_specular_found", name), found)};
    if (owners) data.object_ids = pass.read(render.graph.find("object_id"));
    pass.depends_on(styles_key(frame), frame.least_curvature, render.shaders->generation());
    pass.draws_in(frame.rects.lines);
}

} // namespace

void ToneLinePasses::declare(World& world) {
    const ToneLineFrame& frame = world.resource<ToneLineFrame>();
    const FrameRequests& requests = world.resource<FrameRequests>();
    const bool maps =
        requests.wants("ridge_distance") || requests.wants("ridge_curvature") || requests.wants("line_opacity");
    const bool points =
        requests.wants("ridge_points") || requests.wants("specular_ridge_points") || requests.wants("ridge_directions");
    const bool tones = requests.wants("tone") || requests.wants("tone_specular");
    if (!frame.pixels && !maps && !points && !tones) return;
    Textures textures;
    declare_tone(world, textures);
    if (requests.wants("tone_specular")) declare_specular(world, textures);
    if (!frame.pixels && !maps && !points) return;
    declare_blur(world, textures);
    if (frame.pixels) declare_lines(world, textures);
    if (maps) declare_maps(world, textures);
    if (points) declare_points(world, textures);
}

void ToneLinePasses::declare_tone(World& world, Textures& textures) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const ToneLineFrame& frame = world.resource<ToneLineFrame>();
    const View& view = world.resource<View>();
    const gpu::Format format = tone_format(frame.quality.storage, frame.varying);
    const int samples = frame.quality.samples;
    const TonePass& made = render.graph.add_pass<TonePass>(
        "tone",
        [&](gpu::PassBuilder& pass, TonePass& data) {
            data.tone = pass.create("tone", {view.width, view.height, format});
            render.graph.publish("tone", data.tone);
            data.depth = pass.create(
                "tone_depth",
                {.width = view.width, .height = view.height, .format = gpu::Format::depth32f, .samples = samples});
            if (samples > 1)
                data.samples = pass.create(
                    "tone_samples", {.width = view.width, .height = view.height, .format = format, .samples = samples});
            if (frame.pictures) data.pictures = pass.read(render.graph.find("picture_tone"));
            gpu::KeyHash key;
            shading_.add_key(world, key);
            pass.depends_on(world.resource<DrawList>().key, world.resource<LightList>().key(), key.value(),
                            world.last_changed<AbstractedLines>(), world.last_changed<Toon>(), styles_key(frame),
                            render.shaders->generation());
            pass.draws_in(frame.rects.shaded);
        },
        [this, &world, &render](const TonePass& data, gpu::PassContext& pass) {
            const ToneLineFrame& drawn = world.resource<ToneLineFrame>();
            const std::uint32_t target = pass.texture(data.samples ? data.samples : data.tone);
            const gpu::Framebuffer& framebuffer = render.backend->framebuffer({target}, pass.texture(data.depth));
            framebuffer.bind();
            gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()},
                        .scissor = drawn.rects.shaded,
                        .depth_test = gpu::DepthTest::always,
                        .depth_write = true});
            framebuffer.clear_color(0, background_tone);
            framebuffer.clear_depth(0.0f);
            if (data.pictures) draw_pictures(world, render, pass.texture(data.pictures));
            shading_.draw(world, render, drawn);
            if (!data.samples) return;
            gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = drawn.rects.shaded});
            framebuffer.blit_color(render.backend->framebuffer({pass.texture(data.tone)}));
        });
    textures.tone = made.tone;
}

/// The specular tone in a texture of its own: a buffer that is asked for has its own channels.
void ToneLinePasses::declare_specular(World& world, const Textures& textures) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    render.graph.add_pass<SpecularPass>(
        "tone_specular",
        [&](gpu::PassBuilder& pass, SpecularPass& data) {
            data.tone = pass.read(textures.tone);
            const gpu::TextureDesc& desc = render.graph.desc(data.tone);
            data.specular = pass.create("tone_specular", {desc.width, desc.height, gpu::Format::r32f});
            render.graph.publish("tone_specular", data.specular);
            pass.depends_on(render.shaders->generation());
        },
        [&render](const SpecularPass& data, gpu::PassContext& pass) {
            const gpu::TextureDesc& desc = pass.desc(data.specular);
            render.backend->framebuffer({pass.texture(data.specular)}).bind();
            render.draw_full_screen("abstracted_lines/specular.frag", {.viewport = {0, 0, desc.width, desc.height}},
                                    {pass.texture(data.tone)});
        });
}

void ToneLinePasses::declare_blur(World& world, Textures& textures) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const ToneLineFrame& frame = world.resource<ToneLineFrame>();
    const std::vector<double> steps = stack_steps(widths_of(frame));
    const BlurPass& made = render.graph.add_pass<BlurPass>(
        "tone_blur",
        [&](gpu::PassBuilder& pass, BlurPass& data) {
            data.tone = pass.read(textures.tone);
            const gpu::TextureDesc desc = render.graph.desc(textures.tone);
            for (std::size_t i = 0; i < steps.size(); ++i) {
                data.levels.push_back(pass.create(fmt::format("tone_level_{}", i), desc));
                auto& scratch = data.scratch.emplace_back();
                for (const gpu::TextureDesc& other : ToneBlurJob::scratch(frame.quality.blur, steps[i], desc))
                    scratch.push_back(pass.create(fmt::format("tone_scratch_{}_{}", i, scratch.size()), other));
            }
            pass.depends_on(styles_key(frame), render.shaders->generation());
            pass.draws_in(frame.rects.blurred);
        },
        [&world, &render, steps](const BlurPass& data, gpu::PassContext& pass) {
            const ToneLineFrame& drawn = world.resource<ToneLineFrame>();
            if (drawn.rects.empty()) return;
            // Each level blurs the one before it a little more; all but the last are also looked at around what is.
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const gpu::Rect rect = i + 1 == steps.size() ? drawn.rects.blurred : drawn.rects.shaded;
                std::vector<std::uint32_t> scratch;
                for (const TextureHandle handle : data.scratch[i]) scratch.push_back(pass.texture(handle));
                ToneBlurJob{.kind = drawn.quality.blur,
                            .sigma = steps[i],
                            .from = i == 0 ? pass.texture(data.tone) : pass.texture(data.levels[i - 1]),
                            .to = pass.texture(data.levels[i]),
                            .valid = drawn.rects.shaded,
                            .rect = rect}
                    .run(render, scratch);
            }
        });
    textures.levels = made.levels;
}

void ToneLinePasses::declare_lines(World& world, const Textures& textures) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    render.graph.add_pass<FindPass>(
        "abstracted_lines",
        [&](gpu::PassBuilder& pass, FindPass& data) {
            declare_find(world, pass, "abstracted_lines", textures.levels, !world.resource<ToneLineFrame>().uniform,
                         data);
            data.lines = write_line_layer(world, pass);
            if (!world.resource<ToneLineFrame>().varying)
                data.candidates = pass.create("line_candidates", {view.width, view.height, gpu::Format::depth32f});
        },
        [this, &world, &render](const FindPass& data, gpu::PassContext& pass) {
            bind_line_layer(world, pass, data.lines);
            const std::uint32_t layer = pass.texture(data.lines.layer);
            const gpu::Framebuffer& marked = data.candidates
                                                 ? render.backend->framebuffer({layer}, pass.texture(data.candidates))
                                                 : render.backend->framebuffer({layer});
            find_lines(world, data, pass, finder_, marked, LineOutput::layer);
        });
}

void ToneLinePasses::declare_maps(World& world, const Textures& textures) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    graph.add_pass<FindPass>(
        "ridge_maps",
        [&](gpu::PassBuilder& pass, FindPass& data) {
            declare_find(world, pass, "ridge_maps", textures.levels, !world.resource<ToneLineFrame>().uniform, data);
            for (const char* name : {"ridge_distance", "ridge_curvature", "line_opacity"}) {
                data.targets.push_back(pass.create(name, {view.width, view.height, gpu::Format::rg32f}));
                graph.publish(name, data.targets.back());
            }
        },
        [this, &world, &render](const FindPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& maps = render.backend->framebuffer(
                {pass.texture(data.targets[0]), pass.texture(data.targets[1]), pass.texture(data.targets[2])});
            bind_whole(maps);
            maps.clear_color(0, std::array{1e10f, 1e10f, 0.0f, 0.0f});
            for (const int i : {1, 2}) maps.clear_color(i, std::array{0.0f, 0.0f, 0.0f, 0.0f});
            find_lines(world, data, pass, finder_, maps, LineOutput::maps);
        });
}

void ToneLinePasses::declare_points(World& world, const Textures& textures) {
    struct Target {
        const char* name;
        gpu::Format format;
    };
    static constexpr std::array<Target, 5> targets{{{"ridge_points", gpu::Format::rgba32f},
                                                    {"ridge_directions", gpu::Format::rgba16f},
                                                    {"specular_ridge_points", gpu::Format::rgba32f},
                                                    {"specular_ridge_directions", gpu::Format::rgba16f},
                                                    {"ridge_owner", gpu::Format::r32ui}}};
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    graph.add_pass<FindPass>(
        "ridge_points",
        [&](gpu::PassBuilder& pass, FindPass& data) {
            declare_find(world, pass, "ridge_points", textures.levels, true, data);
            for (const Target& target : targets) {
                data.targets.push_back(pass.create(target.name, {view.width, view.height, target.format}));
                graph.publish(target.name, data.targets.back());
            }
        },
        [this, &world, &render](const FindPass& data, gpu::PassContext& pass) {
            const auto id = [&](std::size_t i) { return pass.texture(data.targets[i]); };
            const gpu::Framebuffer& points = render.backend->framebuffer({id(0), id(1), id(2), id(3), id(4)});
            bind_whole(points);
            for (const int i : {0, 1, 2, 3}) points.clear_color(i, std::array{0.0f, 0.0f, 0.0f, 0.0f});
            points.clear_color(4, std::array{0u, 0u, 0u, 0u});
            find_lines(world, data, pass, finder_, points, LineOutput::points);
        });
}

} // namespace hachure
