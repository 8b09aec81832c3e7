#pragma once

#include <hachure/systems/implicit_brush/convolve_job.h>

#include <cstdint>

namespace hachure::gpu {
class Program;
}

namespace hachure {

struct RenderContext;

/// What was counted, and done, in a run of StampConvolver.
struct ConvolutionCounts {
    BrushMethod method = BrushMethod::automatic; ///< never automatic
    std::uint32_t stamps = 0;                    ///< pixels that stamp
    std::uint32_t tiles = 0;                     ///< of 16 x 16 pixels, that may get ink
    std::uint32_t pairs = 0;                     ///< of a tile and a stamp that may reach it
};

/// What a job costs with each method, ns: of all of it, a stamp, a tile, and a pair of both.
struct ConvolutionPrices {
    double splat_stamp, splat_tile;
    double gather_tile, gather_pair;
    double marked_tile, marked_pair;
    double sum_all, sum_stamp, sum_tile; ///< `sum_all` is less than 0 where there are no running sums

    /// What plan.comp compares.
    [[nodiscard]] double of(BrushMethod method, const ConvolutionCounts& counts) const;
    /// The uniforms of plan.comp.
    void set(gpu::Program& plan) const;
};

/// What the steps of adding stamps up cost on a context, ns. The values are llvmpipe's, of one core [measured].
struct ConvolutionCost {
    double splat_stamp = 800.0; ///< to draw a box at all
    double splat_pixel = 4.5;   ///< each pixel of it
    double sum_pixel = 20.0;    ///< to turn a sum into ink
    double running_sum = 8.0;   ///< to add up along a row
    double edge = 9.0;          ///< to write one pixel of a disk's rim
    double gather_look = 7.0;   ///< to look at a pixel that does not stamp
    double gather_stamp = 12.0; ///< to add one that does
    double marked_look = 16.0;  ///< to look at the marks of 32 pixels
    double marked_stamp = 7.5;  ///< to add one of them

    [[nodiscard]] ConvolutionPrices prices(const ConvolveJob& job, int picture_width, int picture_height) const;
};

/// Those of a context: as given for software rasterisers, so that they choose alike in every run; on other devices
/// scaled by how long a small picture takes there with each method, some milliseconds and the compilation of shaders.
[[nodiscard]] ConvolutionCost context_cost(RenderContext& render);

/// The latter on any device.
[[nodiscard]] ConvolutionCost measured_cost(RenderContext& render);

} // namespace hachure
