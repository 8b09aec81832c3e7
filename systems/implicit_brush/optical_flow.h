#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/texture_desc.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

struct RenderContext;

/// How what a picture shows has moved since the picture before: least squares over a window around each pixel (Lucas
/// and Kanade 1981), coarse to fine, from 1/32 of the resolution to a half of it. Brightness may change by a constant
/// and a factor in the window, as with a flash or another exposure. Where there is nothing to see, motion is that of
/// the surroundings. Textures are ids of the frame graph's back end.
struct OpticalFlowJob {
    std::uint32_t before = 0, now = 0; ///< tones in red, [0, 1], of one size
    /// Rg32f of half that size, rounded up: pixels of the full size, right and up, that the middle of four pixels has
    /// moved; what it shows was at its place less the motion.
    std::uint32_t to = 0;

    /// The shape of `to` for pictures of that size.
    [[nodiscard]] static gpu::TextureDesc flow_desc(int width, int height);

    /// Textures that it works in, for pictures of that size.
    [[nodiscard]] static std::vector<gpu::TextureDesc> scratch(int width, int height);

    void run(RenderContext& render, std::span<const std::uint32_t> scratch) const;
};

} // namespace hachure
