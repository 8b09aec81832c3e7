#pragma once

#include <hachure/runtime/gpu/framebuffer.h>

#include <cstdint>

namespace hachure {

struct RenderContext;

/// Anisotropic diffusion of slopes, with contours as insulators (section 3.2.1). A step is one of the explicit scheme
/// with weights 1 2 1 along either axis: it adds a variance of 1/2 px^2 to each, so that values move by a pixel (root
/// mean square), which is as far as an explicit step on 3x3 pixels can go without weights below 0. A pixel whose neighbour
/// on one side is cut off takes nothing from the one on the other: slopes that grow towards a contour keep growing.
///
/// Several steps are done at once, first along one axis, then along the other: what insulates lets nothing through
/// either way, and without insulators both orders are the same.
struct SlopeDiffusionJob {
    int steps = 1;                  ///< >= 1
    int steps_at_once = 1;          ///< [1, 8]: more are fewer passes of more work each
    std::uint32_t from = 0;         ///< slopes of a surface or of tones
    std::uint32_t to = 0;           ///< another texture of its shape
    std::uint32_t scratch = 0;      ///< a third
    gpu::Rect rect;                 ///< the part of `from` that holds slopes, and that is made
    std::uint32_t depth_buffer = 0; ///< reversed: all slopes are where it is not empty; 0: anywhere

    void run(RenderContext& render) const;
};

} // namespace hachure
