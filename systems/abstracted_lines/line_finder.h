#pragma once

#include <hachure/components/tone_image.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/abstracted_lines/tone_line_style.h>

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
    /// The framebuffer has a depth buffer, clear where lines can be: pixels that can have one are marked there first,
    /// and no others are searched. Widths must not vary.
    bool mark_first = false;
};

/// Runs the job, and keeps the buffer that it needs.
class LineFinder {
public:
    /// Draws into the framebuffer that is bound.
    void run(RenderContext& render, const LineFindJob& job);

private:
    void upload(const LineFindJob& job);
    void mark_candidates(RenderContext& render, const LineFindJob& job) const;
    /// Of the pixels that are marked for these channels, or of all.
    void search(RenderContext& render, const LineFindJob& job, int channels) const;
    gpu::Buffer buffer_;
    bool uniform_ = false; ///< what the buffer is for
};

} // namespace hachure
