#pragma once

#include <hachure/components/tone_image.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/abstracted_lines/tone_line_style.h>

#include <vector>

namespace hachure {

/// The rectangles of a tone image: each step needs more around what the next one makes.
struct ToneRects {
    gpu::Rect lines;   ///< where lines can be
    gpu::Rect blurred; ///< where they look at the blurred image
    gpu::Rect shaded;  ///< where that looks at the tone image

    [[nodiscard]] bool empty() const { return lines.width <= 0 || lines.height <= 0; }
};

/// What this frame draws of abstracted lines. A resource.
struct ToneLineFrame {
    ToneImage quality;                 ///< resolved
    std::vector<ToneLineStyle> styles; ///< by object id; zeros for those without lines
    ToneLineStyle only;                ///< the one that all have, where `uniform`
    bool uniform = false;              ///< everything drawn has lines, of one style: no pixel needs to ask whose it is
    bool pixels = false;               ///< some lines are drawn by pixels
    bool strokes = false;              ///< some are strokes
    bool pictures = false;             ///< some are those of pictures, which then belong to the tone image
    bool varying = false;              ///< widths vary over the picture
    float narrowest = 0.0f;            ///< px, of any line; at least `narrowest_search`
    float widest = 0.0f;               ///< px, likewise
    float least_curvature = 1.0f;      ///< of any line
    ToneRects rects;
};

} // namespace hachure
