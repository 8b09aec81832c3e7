#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/systems/implicit_brush/convolution_cost.h>
#include <hachure/systems/implicit_brush/convolve_job.h>

#include <cstdint>
#include <optional>
#include <span>

namespace hachure {

struct RenderContext;

/// Adds up the stamps of brushes and paints their lines. It keeps what the GPU writes its draws into: pixels that stamp
/// are found and counted there, the way to add them up is chosen there, and nothing is drawn where no stamp reaches.
/// All ways add in the same order, row by row, so that pictures do not depend on the choice.
class StampConvolver {
public:
    /// `scratch`: textures as the job asked for.
    void run(RenderContext& render, const ConvolveJob& job, std::span<const std::uint32_t> scratch);

    /// Of the latest run; waits for the GPU.
    [[nodiscard]] ConvolutionCounts counts() const;

private:
    struct Run;

    void mark(const Run& run) const;
    void plan(const Run& run);
    void list(const Run& run) const;
    void splat(const Run& run) const;
    void sum(const Run& run) const;
    void clear_sums(const Run& run, const gpu::Rect& texels) const;
    void gather(const Run& run, bool marked) const;
    void draw_tiles(const Run& run, std::size_t command) const;

    gpu::Buffer plan_;
    gpu::VertexArray vertex_array_;
    std::optional<ConvolutionCost> cost_; ///< of this context
};

} // namespace hachure
