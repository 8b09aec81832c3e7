#pragma once

#include <cstddef>
#include <cstdint>

namespace hachure {

/// The side of a tile, px.
inline constexpr int convolution_tile = 16;

/// The side of a block of pixels that look at the same stamps (BrushMethod::tiles), px.
inline constexpr int gather_block = 8;

/// The tiles that so many pixels take.
[[nodiscard]] constexpr int tiles_of(int pixels) { return (pixels + convolution_tile - 1) / convolution_tile; }

/// Arguments of glDrawArraysIndirect.
struct IndirectDraw {
    std::uint32_t vertices, instances, first_vertex, first_instance;
};

/// What the GPU decides: the same as in shaders/implicit_brush/plan.glsl.
struct ConvolutionPlan {
    IndirectDraw splats, splat_tiles, gather_tiles, marked_tiles, sum_tiles, sum_clear;
    std::uint32_t list_groups[3];
    std::uint32_t method; ///< a BrushMethod
    std::uint32_t edge_groups[3];
    std::uint32_t stamp_count;
    std::uint32_t sum_groups[3];
    std::uint32_t tile_count;
    std::uint32_t pair_count;
    std::uint32_t padding[3]; ///< std430 makes the block a multiple of 16 bytes
};

} // namespace hachure
