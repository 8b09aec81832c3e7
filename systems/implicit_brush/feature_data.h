#pragma once

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/implicit_brush/feature_window.h>

#include <cstdint>

namespace hachure {

struct RenderContext;

/// Height, direction and singularity of a feature at every pixel, from slopes (section 3.2.1, table 1).
struct FeatureDataJob {
    BrushFeature feature = BrushFeature::ridges;
    bool luminance = false; ///< slopes are those of tones
    FeatureWindow window;
    std::uint32_t slopes = 0;       ///< of the surface or of tones; for contours breaks
    std::uint32_t scratch = 0;      ///< of the shape of `to`
    std::uint32_t scratch_2 = 0;    ///< another, for contours
    std::uint32_t to = 0;           ///< FeatureTextures::data
    gpu::Rect rect;                 ///< the part of `slopes` that holds slopes, and that is made
    std::uint32_t depth_buffer = 0; ///< reversed: all slopes are where it is not empty; 0: anywhere, as contours

    void run(RenderContext& render) const;
};

/// Over how many pixels a contour is smoothed to either side: so far that whoever looks through the window sees its
/// slope.
[[nodiscard]] int contour_reach(float window);

/// The window, px, that contours are smoothed for where theirs is in metres, and so is another at each pixel.
inline constexpr float middling_contour_window = 8.0f;

} // namespace hachure
