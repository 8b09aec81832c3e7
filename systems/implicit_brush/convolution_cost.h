#pragma once

#include <hachure/systems/implicit_brush/convolve_job.h>

namespace hachure::gpu {
class Program;
}

namespace hachure {

/// What the steps of adding stamps up cost on a context, ns. The values are llvmpipe's, of one core [measured].
struct ConvolutionCost {
    double splat_stamp = 800.0; ///< to draw a box at all
    double splat_pixel = 4.5;   ///< each pixel of it
    double sum_pixel = 20.0;    ///< to clear a sum and turn it into ink
    double running_sum = 8.0;   ///< to add up along a row
    double edge = 9.0;          ///< to write one pixel of a disk's rim
    double gather_look = 7.0;   ///< to look at a pixel that does not stamp
    double gather_stamp = 12.0; ///< to add one that does
    double marked_look = 16.0;  ///< to look at the marks of 32 pixels
    double marked_stamp = 7.5;  ///< to add one of them

    /// The uniforms of plan.comp: costs of a stamp, a tile, and a pair of both.
    void set(gpu::Program& plan, const ConvolveJob& job, int picture_width, int picture_height) const;
};

} // namespace hachure
