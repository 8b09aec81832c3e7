#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_frame.h>
#include <hachure/systems/implicit_brush/brush_maps.h>
#include <hachure/systems/implicit_brush/brush_passes.h>

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

namespace hachure {
namespace {

using gpu::TextureHandle;

void depend_on_rect(gpu::PassBuilder& pass, const gpu::Rect& rect) {
    pass.depends_on(rect.x, rect.y, rect.width, rect.height);
    pass.covers(static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height));
}

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

struct StampPass {
    TextureHandle data, profile, depth, object_id, color, noise;
    TextureHandle place, ink;
};

struct InkPass {
    TextureHandle place, ink, noise, layer;
    std::vector<TextureHandle> scratch;
    bool clear = false;
};

} // namespace

void BrushPasses::declare(World& world) {
    const BrushFrame& frame = world.resource<BrushFrame>();
    if (frame.features.empty()) return;
    const std::vector<FeatureTextures> features = features_.declare(world, frame.features, frame.rect);
    const std::vector<TextureHandle> noises = noises_.declare(world, frame.noises, frame.rect);
    std::vector<BrushInk> inks;
    for (std::size_t i = 0; i < frame.draws.size(); ++i) {
        const BrushDraw& draw = frame.draws[i];
        const TextureHandle noise = draw.noise ? noises[*draw.noise] : TextureHandle{};
        const Stamps stamps = declare_stamps(world, i, features[draw.feature], noise);
        declare_ink(world, i, stamps, noise);
        inks.push_back({stamps.ink, draw.rect});
    }
    declare_feature_maps(world, features[frame.draws.empty() ? 0 : frame.draws.front().feature]);
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
            data.place = pass.create(fmt::format("brush_place_{}", index), {view.width, view.height, gpu::Format::rgba16f});
            data.ink = pass.create(fmt::format("brush_ink_{}", index), {view.width, view.height, gpu::Format::rgba16f});
            pass.depends_on(view.key(), style_key(draw.style), owners_key(frame, index), render.shaders->generation());
            depend_on_rect(pass, draw.rect);
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
                                 .rect = drawn.draws[index].rect,
                                 .place = id(data.place),
                                 .ink = id(data.ink)});
        });
    return {made.place, made.ink};
}

} // namespace hachure
