#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/vertex_textures.h>

#include <cstdint>

namespace hachure {

struct RenderContext;

/// Textures that say of each pixel where on its surface it is, whatever pose that is in.
struct PlaceTextures {
    std::uint32_t depth_buffer = 0; ///< in: the surfaces that are seen
    /// Out, rgba32f: place on the surface at rest, relative to the middle of its mesh, in radii of the mesh; and radii
    /// that a pixel spans there, 0 where there is no surface.
    std::uint32_t places = 0;
    /// Out, rg32ui: a seed of the object's own; metres in a radius, as the bits of a float.
    std::uint32_t objects = 0;
};

/// Draws them.
class SurfacePlaces {
public:
    /// All surfaces of the world's DrawList, into `rect`.
    void draw(const World& world, RenderContext& render, const PlaceTextures& textures, const gpu::Rect& rect);

private:
    void draw_item(const World& world, RenderContext& render, const DrawItem& item);

    VertexTextures rest_positions_{"rest positions"};
};

/// Metres in the world to one unit of the mesh at rest: what transform and skin scale by, in the middle of all
/// directions and joints. It does not change while joints only turn and move.
[[nodiscard]] float rest_scale(const World& world, const DrawItem& item);

} // namespace hachure
