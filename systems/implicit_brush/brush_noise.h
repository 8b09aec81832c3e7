#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/implicit_brush/brush_noise_key.h>
#include <hachure/systems/implicit_brush/noise_phases.h>
#include <hachure/systems/implicit_brush/surface_places.h>

#include <array>
#include <span>
#include <vector>

namespace hachure {

/// Declares the passes that fill textures with noise for brushes.
class BrushNoisePasses {
public:
    /// In stage `render`, in every frame, also in those that are not drawn: one texture for each key, of the view's
    /// size, rgba16f, with four independent channels in [-1, 1]; what lies outside `rect` is undefined. Give each key
    /// once. After the passes that draw the surfaces.
    std::vector<gpu::TextureHandle> declare(World& world, std::span<const BrushNoiseKey> keys, const gpu::Rect& rect);

private:
    struct Places {
        gpu::TextureHandle places, objects;
    };

    using Pasts = std::array<gpu::TextureHandle, 2>;

    Places declare_places(World& world, const gpu::Rect& rect);
    Pasts declare_pasts(World& world, std::size_t index, const gpu::Rect& rect);
    std::vector<Pasts> declare_all_pasts(World& world, std::span<const BrushNoiseKey> keys, const gpu::Rect& rect);
    static gpu::TextureHandle declare_noise(World& world, const BrushNoiseKey& key, std::size_t index,
                                            const Places& places, const Pasts& pasts, const gpu::Rect& rect);

    SurfacePlaces places_;
    std::vector<NoisePhases> phases_; ///< one for each lifetime that some noise has
};

} // namespace hachure
