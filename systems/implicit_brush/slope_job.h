#pragma once

#include <hachure/runtime/gpu/framebuffer.h>

#include <cstdint>

namespace hachure {

struct RenderContext;

/// What a texture of slopes is of.
enum class SlopeKind : std::uint8_t {
    /// The surface: red and green the slope of its relief, pixels per pixel along the picture's axes, uphill, at most 4
    /// long;
    /// blue how much a contour insulates the pixel, in [0, 1]; alpha 1 where there is something, else 0.
    surface,
    breaks,    ///< red and green: the gradient of the breaks of depth, each in [-2, 2]; alpha is 1
    luminance, ///< as `surface`, of the relief of tones, tone per pixel
};

/// Makes slopes from what was drawn. Textures are ids of the frame graph's back end, of one size; 0 for none. The
/// view's uniforms are bound.
struct SlopeJob {
    SlopeKind kind = SlopeKind::surface;
    std::uint32_t depth_buffer = 0; ///< reversed; for `surface` and `breaks`
    std::uint32_t normals = 0;      ///< in the world; likewise
    /// Depth (metres from the eye's plane) and normals (world) where the depth buffer is empty: of another renderer.
    /// May hold anything, NaN and infinite too, which is nothing.
    std::uint32_t picture_depth = 0, picture_normals = 0;
    std::uint32_t tones = 0;      ///< for `luminance`: red the tone, green 1 where there is something
    std::uint32_t insulation = 0; ///< likewise: slopes of the surface, whose contours insulate; may be 0
    float half_break = 6.0f;      ///< px: a depth break of so many footprints of a pixel counts half
    gpu::Rect rect;               ///< the part of `to` that is made
    std::uint32_t to = 0;         ///< rgba16f or rgba32f

    void run(RenderContext& render) const;
};

} // namespace hachure
