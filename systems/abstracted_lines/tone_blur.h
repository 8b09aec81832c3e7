#pragma once

#include <hachure/components/tone_image.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/texture_desc.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

struct RenderContext;

/// Blurs a tone image with a Gaussian. Textures are ids of the frame graph's back end, all of one size.
struct ToneBlurJob {
    ToneBlur kind = ToneBlur::separable;
    double sigma = 2.0;     ///< px
    std::uint32_t from = 0; ///< of any float format
    std::uint32_t to = 0;   ///< of the same format
    gpu::Rect valid;        ///< the part of `from` that holds tones; those at its rim go on beyond it
    gpu::Rect rect;         ///< the part of `to` that is made

    /// Textures that it works in, besides `from` and `to`; for an image of the shape of those.
    [[nodiscard]] static std::vector<gpu::TextureDesc> scratch(ToneBlur kind, double sigma,
                                                               const gpu::TextureDesc& desc);

    void run(RenderContext& render, std::span<const std::uint32_t> scratch) const;
};

} // namespace hachure
