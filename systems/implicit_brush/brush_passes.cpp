#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/implicit_brush/brush_frame.h>
#include <hachure/systems/implicit_brush/brush_passes.h>
#include <hachure/systems/implicit_brush/feature_aovs.h>
#include <hachure/systems/implicit_brush/feature_quality.h>
#include <hachure/systems/implicit_brush/weight_map.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace hachure {
namespace {

using gpu::TextureHandle;

std::uint64_t owners_key(const BrushFrame& frame, std::size_t draw) {
    gpu::KeyHash key;
    for (std::uint32_t id = 0; id * frame.owner_words < frame.owners.size(); ++id)
        key.add(static_cast<std::uint32_t>(frame.owns(draw, id)));
    return key.value();
}

std::uint64_t style_key(const BrushStyle& style) {
    return gpu::key_of(style.peak, style.spread, style.size, style.color, style.weak_color, style.tint, style.drivers,
                       style.choices, style.noise, style.scale);
}

/// What painting depends on besides its stamps.
std::uint64_t paint_key(const BrushDraw& draw) {
    const ImplicitBrush& brush = draw.brush;
    return gpu::key_of(static_cast<int>(brush.tip), std::string_view(brush.tip_file), brush.aspect, brush.opacity,
                       brush.contrast, brush.canvas, brush.peak, draw.radius, static_cast<int>(brush.method),
                       draw.style.size, draw.style.color);
}

/// Whether all stamps lie alike about their pixels.
bool same_place(const ImplicitBrush& brush) {
    const bool turned = brush.turn != BrushTurn::fixed || brush.turn_noise > 0.0f;
    const bool moved = brush.shift_along != 0.0f || brush.shift_across != 0.0f || brush.wobble > 0.0f;
    const bool sized =
        brush.size_by != BrushDriver::constant || brush.size_noise > 0.0f || brush.unit == BrushUnit::world;
    return !turned && !moved && !sized;
}

/// All of it but the textures.
ConvolveJob convolve_job(const BrushDraw& draw, const FeatureImage& quality, const TipBitmap* bitmap) {
    const ImplicitBrush& brush = draw.brush;
    ConvolveJob job{
        .method = brush.method,
        .stamps = draw.stamps,
        .footprint = {.tip = brush.tip, .aspect = brush.aspect, .bitmap_mean = bitmap ? bitmap->mean : 0.0f},
        .bitmap = bitmap,
        .radius = draw.radius,
        .largest_radius = draw.radius,
        .largest_shift = largest_shift(brush) * draw.radius,
        .peak = brush.peak,
        .contrast = brush.contrast,
        .opacity = brush.opacity,
        .canvas = {.amount = brush.canvas},
        .sums = feature_format(quality.storage)};
    if (same_place(brush)) job.same_place = glm::vec4(0.0f, 0.0f, draw.radius, brush.angle);
    if (brush.coloring == BrushColor::constant && brush.color_noise <= 0.0f) job.same_color = brush.color;
    return job;
}

struct StampPass {
    TextureHandle data, profile, depth, object_id, color, noise;
    TextureHandle place, ink;
};

struct InkPass {
    TextureHandle place, ink, noise;
    std::vector<TextureHandle> scratch;
    LineTarget lines;
};

} // namespace

void BrushPasses::declare(World& world) {
    const BrushFrame& frame = world.resource<BrushFrame>();
    if (frame.features.empty()) return;
    const std::vector<FeatureTextures> features = features_.declare(world, frame.quality, frame.features, frame.sought);
    const std::vector<TextureHandle> noises = noises_.declare(world, frame.noises, united(frame.sought, frame.rect));
    std::vector<BrushInk> inks;
    for (std::size_t i = 0; i < frame.draws.size(); ++i) {
        const BrushDraw& draw = frame.draws[i];
        const TextureHandle noise = draw.noise ? noises[*draw.noise] : TextureHandle{};
        const Stamps stamps = declare_stamps(world, i, features[draw.feature], noise);
        declare_ink(world, i, stamps, noise);
        inks.push_back({stamps.ink, draw.stamps});
    }
    declare_feature_aovs(world, features[frame.draws.empty() ? 0 : frame.draws.front().feature], frame.sought);
    declare_weight_map(world, inks);
}

BrushPasses::Stamps BrushPasses::declare_stamps(World& world, std::size_t index, const FeatureTextures& feature,
                                                TextureHandle noise) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    const BrushFrame& frame = world.resource<BrushFrame>();
    const BrushDraw& draw = frame.draws[index];
    const bool contours = draw.brush.feature == BrushFeature::contours;
    const StampPass& made = graph.add_pass<StampPass>(
        fmt::format("brush_stamps_{}", index),
        [&](gpu::PassBuilder& pass, StampPass& data) {
            data.data = pass.read(feature.data);
            data.profile = pass.read(feature.profile);
            if (contours || draw.brush.unit == BrushUnit::world) data.depth = pass.read(graph.find("depth_buffer"));
            if (!draw.everywhere) data.object_id = pass.read(graph.find("object_id"));
            if (draw.brush.coloring == BrushColor::surface) data.color = pass.read(graph.find("color"));
            if (noise) data.noise = pass.read(noise);
            data.place =
                pass.create(fmt::format("brush_place_{}", index), {view.width, view.height, gpu::Format::rgba16f});
            data.ink = pass.create(fmt::format("brush_ink_{}", index), {view.width, view.height, gpu::Format::rgba16f});
            pass.depends_on(view.key(), style_key(draw.style), owners_key(frame, index), render.shaders->generation());
            pass.draws_in(draw.stamps);
        },
        [this, &world, &render, index, contours](const StampPass& data, gpu::PassContext& pass) {
            const BrushFrame& drawn = world.resource<BrushFrame>();
            const auto id = [&](TextureHandle handle) { return handle ? pass.texture(handle) : 0u; };
            render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
            stamps_.run(render, {.style = &drawn.draws[index].style,
                                 .contours = contours,
                                 .profile = id(data.profile),
                                 .data = id(data.data),
                                 .depth = id(data.depth),
                                 .object_id = id(data.object_id),
                                 .color = id(data.color),
                                 .noise = id(data.noise),
                                 .owner_words = drawn.owner_words,
                                 .owner_bit = index,
                                 .owners = drawn.owners,
                                 .rect = drawn.draws[index].stamps,
                                 .place = id(data.place),
                                 .ink = id(data.ink)});
        });
    return {made.place, made.ink};
}

/// Lays the brush's ink onto the line layer, which is cleared by whoever is first.
void BrushPasses::declare_ink(World& world, std::size_t index, const Stamps& stamps, TextureHandle noise) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const BrushFrame& frame = world.resource<BrushFrame>();
    const BrushDraw& draw = frame.draws[index];
    const TipBitmap* bitmap = draw.brush.tip == BrushTip::bitmap ? &tips_.get(draw.brush.tip_file) : nullptr;
    const ConvolveJob job = convolve_job(draw, frame.quality, bitmap);
    render.graph.add_pass<InkPass>(
        fmt::format("brush_{}", index),
        [&](gpu::PassBuilder& pass, InkPass& data) {
            data.place = pass.read(stamps.place);
            data.ink = pass.read(stamps.ink);
            if (noise && draw.brush.canvas > 0.0f) data.noise = pass.read(noise);
            const std::vector<gpu::TextureDesc> descs = job.scratch(view.width, view.height);
            for (std::size_t i = 0; i < descs.size(); ++i)
                data.scratch.push_back(pass.create(fmt::format("brush_sum_{}_{}", index, i), descs[i]));
            data.lines = write_line_layer(world, pass);
            pass.depends_on(paint_key(draw), render.shaders->generation());
            pass.draws_in(draw.rect);
        },
        [this, &world, &render, job](const InkPass& data, gpu::PassContext& pass) {
            bind_line_layer(world, pass, data.lines);
            ConvolveJob run = job;
            run.places = pass.texture(data.place);
            run.inks = pass.texture(data.ink);
            run.canvas.texture = data.noise ? pass.texture(data.noise) : 0;
            run.target = pass.texture(data.lines.layer);
            std::vector<std::uint32_t> scratch;
            for (const TextureHandle handle : data.scratch) scratch.push_back(pass.texture(handle));
            convolver_.run(render, run, scratch);
        });
}

} // namespace hachure
