#pragma once

#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/tone_blur.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

// The kinds of blur, a file each, and what they share. Textures are ids of the frame graph's back end.

namespace hachure {

/// A rectangle that is larger on each side, within `limit`.
[[nodiscard]] inline gpu::Rect grown(const gpu::Rect& rect, int by_x, int by_y, const gpu::Rect& limit) {
    const int x0 = std::max(rect.x - by_x, limit.x), y0 = std::max(rect.y - by_y, limit.y);
    const int x1 = std::min(rect.x + rect.width + by_x, limit.x + limit.width);
    const int y1 = std::min(rect.y + rect.height + by_y, limit.y + limit.height);
    return {x0, y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0)};
}

/// The texels of half the resolution that these are in.
[[nodiscard]] inline gpu::Rect halved(const gpu::Rect& rect) {
    const int x = rect.x / 2, y = rect.y / 2;
    return {x, y, (rect.x + rect.width + 1) / 2 - x, (rect.y + rect.height + 1) / 2 - y};
}

[[nodiscard]] inline gpu::Rect doubled(const gpu::Rect& rect) {
    return {2 * rect.x, 2 * rect.y, 2 * rect.width, 2 * rect.height};
}

[[nodiscard]] inline gpu::TextureDesc halved(const gpu::TextureDesc& desc) {
    return {(desc.width + 1) / 2, (desc.height + 1) / 2, desc.format};
}

/// One step of a blur by a fragment shader.
struct BlurDraw {
    std::uint32_t from = 0, to = 0;
    gpu::Rect valid; ///< the texels of `from` that hold tones
    gpu::Rect rect;  ///< the texels of `to` that are drawn

    /// By a program that samples between texels (shaders/abstracted_lines/pyramid.glsl).
    void sampled(RenderContext& render, const char* fragment) const;
    /// By one that fetches texels.
    void fetched(RenderContext& render, const gpu::ProgramSource& source) const;

private:
    void draw(RenderContext& render, gpu::Program& program) const;
};

/// By rows into `between`, by columns into `to`, which may be `from`.
void blur_separable(RenderContext& render, const ToneBlurJob& job, std::uint32_t between);
/// All in one step: the reference.
void blur_exact(RenderContext& render, const ToneBlurJob& job);
/// `scratch`: rows there, rows.
void blur_recursive(RenderContext& render, const ToneBlurJob& job, std::span<const std::uint32_t> scratch);
/// `scratch`: a level per halving, and one more of the last's size.
void blur_halved(RenderContext& render, const ToneBlurJob& job, std::span<const std::uint32_t> scratch);
/// `scratch`: a level per halving.
void blur_kawase(RenderContext& render, const ToneBlurJob& job, std::span<const std::uint32_t> scratch);

[[nodiscard]] std::vector<gpu::TextureDesc> recursive_scratch(const gpu::TextureDesc& desc);
[[nodiscard]] std::vector<gpu::TextureDesc> halved_scratch(double sigma, const gpu::TextureDesc& desc);
[[nodiscard]] std::vector<gpu::TextureDesc> kawase_scratch(double sigma, const gpu::TextureDesc& desc);

/// How often tones are halved before they are blurred: as long as two texels of a deviation are left. Finer tones keep
/// lines within .01 px of where they are, coarser ones do not.
[[nodiscard]] int halvings(double sigma);

/// Whether a blur is at least that of a pyramid of one level.
[[nodiscard]] bool fits_pyramid(double sigma);

} // namespace hachure
