#version 450 core
// Ink from running sums in whole numbers.
#include "implicit_brush/stamp.glsl"
#include "implicit_brush/tone.glsl"

layout(binding = 2) uniform usampler2D sums;

uniform float fixed_point;

layout(location = 0) out vec4 out_color;

float sum_at(int x, int y) { return float(int(texelFetch(sums, ivec2(x, y), 0).r)) / fixed_point; }

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef SAME_COLOR
    out_color = toned(sum_at(here.x, here.y), here);
#else
    int x = 4 * here.x;
    out_color = toned(vec4(sum_at(x, here.y), sum_at(x + 1, here.y), sum_at(x + 2, here.y), sum_at(x + 3, here.y)), here);
#endif
}
