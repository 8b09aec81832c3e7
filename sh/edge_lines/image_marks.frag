#version 450 core
// Where the picture's surfaces break off between a pixel and its right and upper neighbour: half the width of that line
// in pixels, 0 for none, and the object whose line it is (times 2, and 1 for a crease).
#include "common/view.glsl"
#include "edge_lines/image_breaks.glsl"
#include "edge_lines/image_styles.glsl"

layout(location = 0) out vec2 out_half_widths;
layout(location = 1) out uvec2 out_marks;

float half_width(ImageStyle style, float nearer) {
    float wide = style.line.w;
    return wide >= 0.0 ? wide : -wide / (eye.w > 0.0 ? view_depth(nearer) : 1.0);
}

void mark(ivec2 pixel, ivec2 side, out float half_wide, out uint object) {
    half_wide = 0.0;
    object = 0u;
    ivec2 other = inside(pixel + side);
    uvec2 code = code_at(pixel), other_code = code_at(other);
    uint a = code.x, b = other_code.x;
    if (a == 0u && b == 0u) return;
    float here = depth_at(pixel), there = depth_at(other);
    // The line is the nearer one's, unless that has none.
    uint first = here >= there ? a : b, second = here >= there ? b : a;
    uint owner = has_lines(first) ? first : second;
    if (!has_lines(owner)) return;
    ImageStyle style = styles[owner];
    bool step = a != b || breaks_off(depth_at(pixel - side), here, there, depth_at(pixel + 2 * side));
    bool crease = a == b && turns(decode_direction(code.y), decode_direction(other_code.y), style.crease_cosine);
    step = step && style.breaks > 0.0;
    if (!step && !crease) return;
    half_wide = half_width(style, max(here, there));
    object = owner * 2u + (step ? 0u : 1u);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    mark(pixel, ivec2(1, 0), out_half_widths.x, out_marks.x);
    mark(pixel, ivec2(0, 1), out_half_widths.y, out_marks.y);
}
