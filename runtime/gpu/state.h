#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/gl.h>

#include <array>
#include <cstdint>
#include <optional>

namespace hachure::gpu {

enum class DepthTest : std::uint8_t { off, less, less_equal, equal, greater, always };
enum class Cull : std::uint8_t { none, back, front };

/// How the colour that a shader gives meets the one that is there.
enum class Blend : std::uint8_t {
    off,
    alpha,         ///< source over destination, alpha not premultiplied
    premultiplied, ///< source over destination, alpha premultiplied
    add,
    multiply,
    min,
    max,
};

/// The fixed-function state of a pass. Its defaults suit a full-screen pass.
struct DrawState {
    Rect viewport = {};               ///< pixels, width and height >= 0
    std::optional<Rect> scissor = {}; ///< where drawing and clearing are confined to, if anywhere

    DepthTest depth_test = DepthTest::off;
    bool depth_write = false; ///< needs a depth test other than off
    Cull cull = Cull::none;   ///< front faces are counter-clockwise
    Blend blend = Blend::off; ///< for all colour attachments
    std::array<bool, 4> color_write = {true, true, true, true};

    /// Linear colours are encoded when they go to an sRGB target; off: values are stored as they are.
    bool srgb_write = false;

    float polygon_offset_factor = 0.0f; ///< times the depth slope; with polygon_offset_units, both 0: off
    float polygon_offset_units = 0.0f;  ///< times the smallest resolvable depth
    float line_width = 1.0f;            ///< pixels; core profiles promise 1 alone
    bool program_point_size = false;    ///< gl_PointSize counts
    bool wireframe = false;             ///< outlines of polygons instead of their insides
};

/// Sets everything a DrawState covers, whatever was set before, so that no state leaks from one pass into the next.
void apply(const DrawState& state);

} // namespace hachure::gpu
