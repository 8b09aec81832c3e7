#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/brush_style.h>

#include <cstdint>
#include <span>

namespace hachure {

/// What a brush stamps at each pixel of a rectangle (Vergne et al. 2011, section 4.1: weight and brush functions).
/// Textures have the size of the view; ids of those that are not needed are 0.
struct StampJob {
    const BrushStyle* style = nullptr;
    bool contours = false;       ///< lines belong to what is nearest beside them
    std::uint32_t profile = 0;   ///< of its feature (feature_job.h)
    std::uint32_t data = 0;      ///< of its feature
    std::uint32_t depth = 0;     ///< the depth buffer, for contours and lengths in metres
    std::uint32_t object_id = 0; ///< 0: the brush paints on everything
    std::uint32_t color = 0;     ///< what is drawn so far, for stamps coloured by it
    std::uint32_t noise = 0;     ///< four channels, each even over [-1, 1]
    std::size_t owner_words = 1; ///< of an object id in `owners`
    std::size_t owner_bit = 0;   ///< among them
    std::span<const std::uint32_t> owners;
    gpu::Rect rect;          ///< where stamps can be; outside it the targets are not touched
    std::uint32_t place = 0; ///< out, rgba16f: the stamp's middle from the pixel's, its radius, px; its angle, radians
    std::uint32_t ink = 0;   ///< out, rgba16f: colour times weight, and weight; 0 where nothing is stamped
};

/// Runs them; the buffers are kept from one to the next.
class StampMaker {
public:
    /// The view's uniforms are bound.
    void run(RenderContext& render, const StampJob& job);

private:
    gpu::Buffer style_, owners_;
};

} // namespace hachure
