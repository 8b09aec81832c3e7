#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph_handle.h>
#include <hachure/runtime/gpu/rect.h>
#include <hachure/runtime/scene/view.h>

#include <string_view>

namespace hachure {

/// What is seen, with several samples of a pixel to a side, as a picture that is larger by that.
struct FineSurface {
    gpu::TextureHandle depth_buffer; ///< depth32f, reversed
    gpu::TextureHandle normals;      ///< in the world, rgba16f; none where only depth was asked for
};

struct FineSurfaceRequest {
    std::string_view pass; ///< its name; that of the textures, with `_depth` and `_normals`
    int samples = 2;       ///< of a pixel, to a side: the view's size times that fits into a texture
    gpu::Rect rect;        ///< pixels of the view: outside it nothing is drawn
    bool normals = false;
};

/// Declares a pass that draws all surfaces. Pixels of the view are `samples` squared texels.
[[nodiscard]] FineSurface declare_fine_surface(World& world, const FineSurfaceRequest& request);

/// A view, or a part of it, whose pixels are those samples.
[[nodiscard]] View fine_view(const View& view, int samples);
[[nodiscard]] gpu::Rect fine_rect(const gpu::Rect& rect, int samples);

} // namespace hachure
