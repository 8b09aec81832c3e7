#pragma once

#include <hachure/components/tone_image.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/abstracted_lines/tone_line_style.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

struct RenderContext;

/// A blurred tone image, and the width of the lines that it is blurred for.
struct ToneLevel {
    std::uint32_t texture = 0; ///< id of the frame graph's back end
    double width = 0.0;        ///< px
};

/// What a line's search makes of each pixel.
enum class LineOutput {
    layer, ///< its colour over what is there, premultiplied: one target
    /// Two channels each, diffuse and specular: distance to the line's middle, px; signed curvature (> 0 in a valley);
    /// and opacity, of dark lines and of highlight lines. Three targets, which keep what they hold where no line is.
    maps,
    points, ///< what strokes are made of: five targets, likewise (shaders/abstracted_lines/lines.frag)
};

/// Finds lines in a tone image: by every pixel for itself, a search for the ridge or valley beside it.
struct LineFindJob {
    ToneImage quality;                     ///< resolved: taps, iterations
    std::span<const ToneLevel> levels;     ///< one, or where widths vary several, ascending
    std::uint32_t widths = 0;              ///< with several: blue width times coverage, alpha coverage
    std::uint32_t object_ids = 0;          ///< 0: every pixel has lines, of the first style
    std::span<const ToneLineStyle> styles; ///< by object id
    float width = 0.0f;                    ///< px, what lines are searched for as where there is one level
    float least_curvature = 0.0f;          ///< of any style
    gpu::Rect rect;                        ///< where lines can be
    LineOutput output = LineOutput::layer;
    /// With targets as `output` says, and with `candidates` as its depth if there are any. Not owned.
    const gpu::Framebuffer* target = nullptr;
    /// Scratch for what pixels find in both channels, before they are asked whether they agree: as `found_desc` says.
    std::array<std::uint32_t, 2> found{};
    /// A depth texture of the targets' size, or 0: pixels that can have a line are marked in it first, and no others
    /// are searched. Its contents are lost. Widths must not vary.
    std::uint32_t candidates = 0;
};

/// Runs the job, and keeps the buffer that it needs.
class LineFinder {
public:
    /// Of LineFindJob::found, for a view.
    [[nodiscard]] static gpu::TextureDesc found_desc(int width, int height);

    void run(RenderContext& render, const LineFindJob& job);

private:
    /// What a pass over the pixels does: search, search and compare with what others found, or draw what was found.
    enum class Step { find, compare, draw };

    void upload(const LineFindJob& job);
    void mark_candidates(RenderContext& render, const LineFindJob& job) const;
    void find(RenderContext& render, const LineFindJob& job) const;
    void write(RenderContext& render, const LineFindJob& job) const;
    /// What a pass over the pixels that are marked for these channels, or over all, draws with.
    [[nodiscard]] static gpu::ProgramSource program_source(const LineFindJob& job, int channels, Step step);
    /// Draws that with the framebuffer that is bound, level by level.
    void draw(RenderContext& render, const LineFindJob& job, int channels, Step step) const;

    gpu::Buffer buffer_;
    bool uniform_ = false; ///< what the buffer is for
};

} // namespace hachure
