#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_maps.h>

#include <algorithm>
#include <string>

namespace hachure {
namespace {

/// What shaders/implicit_brush/feature_map.frag is to write, by map; and whether it has two channels.
struct MapKind {
    const char* define;
    bool vector = false;
};
constexpr std::array<MapKind, 6> map_kinds{
    {{"HEIGHT"}, {"DIRECTION", true}, {"SINGULARITY"}, {"DISTANCE"}, {"LINE_HEIGHT"}, {"CURVATURE"}}};

struct MapPass {
    gpu::TextureHandle data, profile, map;
};

void declare_feature_map(World& world, const FeatureTextures& feature, std::string_view name, const MapKind& kind) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    render.graph.add_pass<MapPass>(
        std::string(name),
        [&](gpu::PassBuilder& pass, MapPass& data) {
            data.data = pass.read(feature.data);
            data.profile = pass.read(feature.profile);
            data.map = pass.create(name, {view.width, view.height, kind.vector ? gpu::Format::rg32f : gpu::Format::r32f});
            render.graph.publish(name, data.map);
            pass.depends_on(render.shaders->generation());
        },
        [&render, kind](const MapPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.map)});
            target.bind();
            render.backend->texture(pass.texture(data.data)).bind(0);
            render.backend->texture(pass.texture(data.profile)).bind(1);
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
            render.shaders
                ->program({.vertex = "common/full_screen.vert",
                           .fragment = "implicit_brush/feature_map.frag",
                           .defines = {{kind.define, ""}}})
                .use();
            render.full_screen.draw();
        });
}

struct WeightPass {
    std::vector<gpu::TextureHandle> inks;
    gpu::TextureHandle weight;
};

} // namespace

void add_brush_maps(std::vector<AovInfo>& known) {
    known.push_back({"feature_height",
                     "height that the first brush finds its lines in: how pronounced its feature is; that of occluding "
                     "contours where no brush paints",
                     {"height"}});
    known.push_back({"feature_direction", "direction across its lines, unit, up to its sign; 0 for none", {"X", "Y"}});
    known.push_back(
        {"feature_singularity", "how far that direction, or depth, breaks off: 0 not at all", {"singularity"}});
    known.push_back({"profile_distance", "pixels to the line that a pixel belongs to; 1e10 for none", {"distance"}});
    known.push_back({"profile_height", "feature_height on that line; 0 for none", {"height"}});
    known.push_back({"profile_curvature",
                     "how sharp that line is: fall of the height over half a window beside it; 0 for none",
                     {"curvature"}});
    known.push_back({"brush_weight", "how much a pixel counts in the brush that it counts most in", {"weight"}});
}

bool wants_feature_maps(const FrameRequests& requests) {
    return std::ranges::any_of(feature_maps, [&](std::string_view name) { return requests.wants(name); });
}

void declare_feature_maps(World& world, const FeatureTextures& feature) {
    const FrameRequests& requests = world.resource<FrameRequests>();
    for (std::size_t i = 0; i < feature_maps.size(); ++i)
        if (requests.wants(feature_maps[i])) declare_feature_map(world, feature, feature_maps[i], map_kinds[i]);
}

void declare_weight_map(World& world, std::span<const BrushInk> inks) {
    if (!world.resource<FrameRequests>().wants("brush_weight")) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const std::vector<BrushInk> drawn(inks.begin(), inks.end());
    render.graph.add_pass<WeightPass>(
        "brush_weight",
        [&](gpu::PassBuilder& pass, WeightPass& data) {
            for (const BrushInk& ink : drawn) {
                data.inks.push_back(pass.read(ink.ink));
                pass.depends_on(ink.rect.x, ink.rect.y, ink.rect.width, ink.rect.height);
            }
            data.weight = pass.create("brush_weight", {view.width, view.height, gpu::Format::r32f});
            render.graph.publish("brush_weight", data.weight);
            pass.depends_on(render.shaders->generation());
        },
        [&render, drawn](const WeightPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.weight)});
            target.bind();
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
            target.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
            for (std::size_t i = 0; i < drawn.size(); ++i)
                render.draw_full_screen("implicit_brush/weight.frag",
                                        {.viewport = {0, 0, target.width(), target.height()},
                                         .scissor = drawn[i].rect,
                                         .blend = gpu::Blend::max},
                                        {pass.texture(data.inks[i])});
        });
}

} // namespace hachure
