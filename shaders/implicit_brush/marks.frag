#version 450 core
// Which pixels stamp: a texel has a bit for each of 32 pixels beside each other, the lowest for the leftmost.
#include "implicit_brush/stamp.glsl"

uniform ivec2 first; // pixels that may stamp
uniform ivec2 last;

layout(location = 0) out uint out_marks;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int left = 32 * texel.x;
    out_marks = 0u;
    for (int x = max(left, first.x); x <= min(left + 31, last.x); ++x) {
        ivec2 pixel = ivec2(x, texel.y);
        float weight = texelFetch(stamp_inks, pixel, 0).a;
        if (weight > 0.0 && is_stamp(place_of(pixel), weight)) out_marks |= 1u << (x - left);
    }
}
