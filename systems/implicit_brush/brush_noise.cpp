#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_noise.h>
#include <hachure/systems/implicit_brush/brush_noise_job.h>

#include <fmt/format.h>

#include <algorithm>

namespace hachure {
namespace {

using gpu::TextureHandle;

struct PlacesPass {
    TextureHandle depth_buffer, places, objects;
};

struct NoisePass {
    TextureHandle places, objects, noise;
};

bool needs_places(const BrushNoiseKey& key) { return key.grain == BrushGrain::solid || key.world_size; }

void depend_on_rect(gpu::PassBuilder& pass, const gpu::Rect& rect) {
    pass.depends_on(rect.x, rect.y, rect.width, rect.height);
    pass.covers(static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height));
}

} // namespace

std::vector<TextureHandle> BrushNoisePasses::declare(World& world, std::span<const BrushNoiseKey> keys,
                                                     const gpu::Rect& rect) {
    Places places;
    if (std::ranges::any_of(keys, needs_places)) places = declare_places(world, rect);
    std::vector<TextureHandle> result;
    for (const BrushNoiseKey& key : keys) result.push_back(declare_noise(world, key, result.size(), places, rect));
    return result;
}

BrushNoisePasses::Places BrushNoisePasses::declare_places(World& world, const gpu::Rect& rect) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    const PlacesPass& pass = graph.add_pass<PlacesPass>(
        "brush_places",
        [&](gpu::PassBuilder& builder, PlacesPass& data) {
            data.depth_buffer = builder.read(graph.find("depth_buffer"));
            data.places = builder.create("brush_places", {view.width, view.height, gpu::Format::rgba32f});
            data.objects = builder.create("brush_objects", {view.width, view.height, gpu::Format::rg32ui});
            builder.depends_on(world.resource<DrawList>().key, render.shaders->generation());
            depend_on_rect(builder, rect);
        },
        [this, &world, &render, rect](const PlacesPass& data, gpu::PassContext& context) {
            places_.draw(
                world, render,
                {context.texture(data.depth_buffer), context.texture(data.places), context.texture(data.objects)},
                rect);
        });
    return {pass.places, pass.objects};
}

TextureHandle BrushNoisePasses::declare_noise(World& world, const BrushNoiseKey& key, std::size_t index,
                                              const Places& places, const gpu::Rect& rect) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const std::string name = fmt::format("brush_noise {}", index);
    const NoisePass& pass = render.graph.add_pass<NoisePass>(
        name,
        [&](gpu::PassBuilder& builder, NoisePass& data) {
            if (needs_places(key)) {
                data.places = builder.read(places.places);
                data.objects = builder.read(places.objects);
            }
            data.noise = builder.create(name, {view.width, view.height, gpu::Format::rgba16f});
            builder.depends_on(key.grain, key.size, key.world_size, key.flatness, key.seed,
                               render.shaders->generation());
            depend_on_rect(builder, rect);
        },
        [&render, key, rect](const NoisePass& data, gpu::PassContext& context) {
            const auto id = [&](TextureHandle handle) { return handle ? context.texture(handle) : 0u; };
            BrushNoiseJob{.key = key,
                          .places = id(data.places),
                          .objects = id(data.objects),
                          .picture_height = static_cast<float>(context.desc(data.noise).height),
                          .to = context.texture(data.noise),
                          .rect = rect}
                .run(render);
        });
    return pass.noise;
}

} // namespace hachure
