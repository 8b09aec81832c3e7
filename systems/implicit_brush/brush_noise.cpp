#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_noise.h>
#include <hachure/systems/implicit_brush/brush_noise_job.h>
#include <hachure/systems/implicit_brush/depend_on_rect.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hachure {
namespace {

using gpu::TextureHandle;

struct PlacesPass {
    TextureHandle depth_buffer, places, objects;
};

struct PastsPass {
    TextureHandle depth_buffer;
    std::array<TextureHandle, 2> pasts;
};

struct NoisePass {
    TextureHandle places, objects, noise;
    std::array<TextureHandle, 2> pasts;
};

/// Pixels that points move against each other while a surface's noise lives. Noise that is still at rest on the surface
/// changes by pi / size of itself in each pixel of motion, noise that is renewed by pi / lifetime: 1/6 of that, and
/// less where it is to keep to the surface more than to the picture's plane.
float lifetime_of(const BrushNoiseKey& key) {
    constexpr float nominal_size = 12.0f; // of grains in metres, whose pixels are different everywhere
    return 6.0f * std::pow(4.0f, 1.0f - key.flatness) * (key.world_size ? nominal_size : std::max(key.size, 1.0f));
}

bool needs_places(const BrushNoiseKey& key) { return key.grain == BrushGrain::solid || key.world_size; }

/// Nothing has moved, and nothing carries noise.
void clear(RenderContext& render, const PhaseTextures& textures, const gpu::Rect& rect) {
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({textures.pasts[0], textures.pasts[1]});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
    for (const int k : {0, 1}) framebuffer.clear_color(k, std::array{0.0f, 0.0f, 0.0f, 0.0f});
}

} // namespace

std::vector<TextureHandle> BrushNoisePasses::declare(World& world, std::span<const BrushNoiseKey> keys,
                                                     const gpu::Rect& rect) {
    Places places;
    if (std::ranges::any_of(keys, needs_places)) places = declare_places(world, rect);
    const std::vector<Pasts> pasts = declare_all_pasts(world, keys, rect);
    std::vector<TextureHandle> result;
    for (std::size_t i = 0; i < keys.size(); ++i)
        result.push_back(declare_noise(world, keys[i], i, places, pasts[i], rect));
    return result;
}

std::vector<BrushNoisePasses::Pasts>
BrushNoisePasses::declare_all_pasts(World& world, std::span<const BrushNoiseKey> keys, const gpu::Rect& rect) {
    std::vector<float> lifetimes;
    for (const BrushNoiseKey& key : keys)
        if (key.grain == BrushGrain::advected) lifetimes.push_back(lifetime_of(key));
    std::erase_if(phases_,
                  [&](const NoisePhases& p) { return std::ranges::find(lifetimes, p.lifetime()) == lifetimes.end(); });
    std::vector<Pasts> by_key(keys.size());
    std::vector<std::optional<Pasts>> declared(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].grain != BrushGrain::advected) continue;
        const float lifetime = lifetime_of(keys[i]);
        auto found = std::ranges::find(phases_, lifetime, &NoisePhases::lifetime);
        if (found == phases_.end()) found = phases_.emplace(phases_.end(), lifetime);
        const auto index = static_cast<std::size_t>(found - phases_.begin());
        if (!declared[index]) declared[index] = declare_pasts(world, index, rect);
        by_key[i] = *declared[index];
    }
    return by_key;
}

BrushNoisePasses::Pasts BrushNoisePasses::declare_pasts(World& world, std::size_t index, const gpu::Rect& rect) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    NoisePhases& phases = phases_[index];
    phases.update(world.resource<MeshStore>(), world.resource<DrawList>(), view);
    const PastsPass& pass = graph.add_pass<PastsPass>(
        fmt::format("brush_pasts {}", index),
        [&](gpu::PassBuilder& builder, PastsPass& data) {
            data.depth_buffer = builder.read(graph.find("depth_buffer"));
            for (std::size_t k = 0; k < 2; ++k)
                data.pasts[k] = builder.create(fmt::format("brush_past {} {}", index, k),
                                               {view.width, view.height, gpu::Format::rgba32f});
            builder.depends_on(phases.key(), phases.lifetime(), render.shaders->generation());
            depend_on_rect(builder, rect);
        },
        [this, index, &world, &render, rect](const PastsPass& data, gpu::PassContext& context) {
            const PhaseTextures textures{context.texture(data.depth_buffer),
                                         {context.texture(data.pasts[0]), context.texture(data.pasts[1])}};
            clear(render, textures, rect);
            phases_[index].draw(world, render, textures, rect);
        });
    return pass.pasts;
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
                                              const Places& places, const Pasts& pasts, const gpu::Rect& rect) {
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
            if (key.grain == BrushGrain::advected)
                for (std::size_t k = 0; k < 2; ++k) data.pasts[k] = builder.read(pasts[k]);
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
                          .pasts = {id(data.pasts[0]), id(data.pasts[1])},
                          .picture_height = static_cast<float>(context.desc(data.noise).height),
                          .to = context.texture(data.noise),
                          .rect = rect}
                .run(render);
        });
    return pass.noise;
}

} // namespace hachure
