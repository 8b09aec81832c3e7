#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_noise.h>
#include <hachure/systems/implicit_brush/brush_noise_job.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
    want_lifetimes(keys);
    const std::vector<Pasts> pasts = declare_all_pasts(world, rect);
    std::vector<TextureHandle> result;
    for (const BrushNoiseKey& key : keys) {
        const auto advection = std::ranges::find(advections_, lifetime_of(key), &Advection::lifetime);
        const bool advected = key.grain == BrushGrain::advected;
        result.push_back(
            declare_noise(world, key, result.size(), places,
                          advected ? pasts[static_cast<std::size_t>(advection - advections_.begin())] : Pasts{}, rect));
    }
    return result;
}

/// Noise that the screen's motion leaves behind changes by pi / size of itself in each pixel of motion, noise that is
/// renewed by pi / lifetime: by 1/6 of that, and less where it is to keep to what it is painted on more than to the
/// picture's plane. In a video 64 frames are the same for motion of a pixel a frame and grains of 12.
BrushNoisePasses::Lifetime BrushNoisePasses::lifetime_of(const BrushNoiseKey& key) {
    constexpr float nominal_size = 12.0f; // of grains in metres, whose pixels are different everywhere
    const float longer = std::pow(4.0f, 1.0f - key.flatness);
    return {6.0f * longer * (key.world_size ? nominal_size : std::max(key.size, 1.0f)),
            2 * static_cast<int>(std::lround(32.0f * std::sqrt(longer)))};
}

void BrushNoisePasses::want_lifetimes(std::span<const BrushNoiseKey> keys) {
    std::vector<Lifetime> wanted;
    std::vector<int> frames;
    for (const BrushNoiseKey& key : keys) {
        if (key.grain != BrushGrain::advected) continue;
        const Lifetime lifetime = lifetime_of(key);
        if (std::ranges::find(wanted, lifetime) == wanted.end()) wanted.push_back(lifetime);
        if (std::ranges::find(frames, lifetime.frames) == frames.end()) frames.push_back(lifetime.frames);
    }
    std::erase_if(advections_,
                  [&](const Advection& a) { return std::ranges::find(wanted, a.lifetime) == wanted.end(); });
    for (const Lifetime& lifetime : wanted)
        if (std::ranges::find(advections_, lifetime, &Advection::lifetime) == advections_.end())
            advections_.push_back({lifetime, NoisePhases(lifetime.pixels)});
    pictures_.want(std::move(frames));
}

std::vector<BrushNoisePasses::Pasts> BrushNoisePasses::declare_all_pasts(World& world, const gpu::Rect& rect) {
    std::vector<Pasts> result;
    for (std::size_t i = 0; i < advections_.size(); ++i) result.push_back(declare_pasts(world, i, rect));
    return result;
}

BrushNoisePasses::Pasts BrushNoisePasses::declare_pasts(World& world, std::size_t index, const gpu::Rect& rect) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    NoisePhases& surfaces = advections_[index].surfaces;
    surfaces.update(world.resource<MeshStore>(), world.resource<DrawList>(), view);
    const PictureList* pictures = world.find_resource<PictureList>();
    const Lifetime lifetime = advections_[index].lifetime;
    const PastsPass& pass = graph.add_pass<PastsPass>(
        fmt::format("brush_pasts {}", index),
        [&](gpu::PassBuilder& builder, PastsPass& data) {
            data.depth_buffer = builder.read(graph.find("depth_buffer"));
            for (std::size_t k = 0; k < 2; ++k)
                data.pasts[k] = builder.create(fmt::format("brush_past {} {}", index, k),
                                               {view.width, view.height, gpu::Format::rgba32f});
            builder.depends_on(surfaces.key(), pictures ? pictures->key : 0, lifetime.pixels, lifetime.frames,
                               render.shaders->generation());
            builder.draws_in(rect);
        },
        [this, index, lifetime, &world, &render, rect](const PastsPass& data, gpu::PassContext& context) {
            const PhaseTextures textures{context.texture(data.depth_buffer),
                                         {context.texture(data.pasts[0]), context.texture(data.pasts[1])}};
            clear(render, textures, rect);
            pictures_.draw(world, render, lifetime.frames, textures, rect);
            advections_[index].surfaces.draw(world, render, textures, rect);
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
            builder.draws_in(rect);
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
            builder.draws_in(rect);
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
