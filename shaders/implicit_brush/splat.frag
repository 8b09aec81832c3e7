#version 450 core
// What a stamp adds; blending sums up.
#include "implicit_brush/stamp.glsl"

flat in ivec2 stamp_pixel;
flat in vec2 stamp_shift;
flat in float stamp_radius;
flat in vec2 stamp_turn;
flat in SUM stamp_ink;

layout(location = 0) out SUM out_sum;

void main() {
    Stamp stamp = Stamp(stamp_shift, stamp_radius, stamp_turn, stamp_ink);
    out_sum = stamped(stamp, stamp_pixel, ivec2(gl_FragCoord.xy));
}
