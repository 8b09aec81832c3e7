#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph_handle.h>
#include <hachure/runtime/gpu/rect.h>
#include <hachure/runtime/scene/view.h>

namespace hachure {

/// What is seen, with so many samples of a pixel to a side (FeatureImage::samples), as a picture that is larger by
/// that.
struct FineSurface {
    gpu::TextureHandle depth_buffer; ///< reversed
    gpu::TextureHandle normals;      ///< in the world, rgba16f
};

/// Declares the pass `brush_fine_surface`, which draws all surfaces in `rect`, pixels of the view. Once a frame.
[[nodiscard]] FineSurface declare_fine_surface(World& world, int samples, const gpu::Rect& rect);

/// A view, or a part of it, whose pixels are those samples.
[[nodiscard]] View fine_view(const View& view, int samples);
[[nodiscard]] gpu::Rect fine_rect(const gpu::Rect& rect, int samples);

} // namespace hachure
