#pragma once

#include <hachure/runtime/gpu/rect.h>

#include <cstdint>

namespace hachure {

struct RenderContext;

/// Smooths with a binomial of `reach` pixels to either side along both axes, a variance of reach / 2, and no
/// insulators.
struct WidenJob {
    int reach = 6;                               ///< [1, 16]
    std::uint32_t from = 0, to = 0, scratch = 0; ///< three textures of one shape
    gpu::Rect rect;

    void run(RenderContext& render) const;
};

} // namespace hachure
