#version 450 core
// Ink from the sums of splats.
#include "implicit_brush/stamp.glsl"
#include "implicit_brush/tone.glsl"

layout(binding = 2) uniform sampler2D sums;

layout(location = 0) out vec4 out_color;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef SAME_COLOR
    out_color = toned(texelFetch(sums, here, 0).r, here);
#else
    out_color = toned(texelFetch(sums, here, 0), here);
#endif
}
