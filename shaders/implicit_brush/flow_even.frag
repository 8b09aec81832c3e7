#version 450 core
// Tones by how they differ from what is around, in deviations of that: the same whatever the exposure is, and whatever
// light is added. Along rows the sums are made, along columns the tones. Define: ROWS for the former.
#include "implicit_brush/flow.glsl"

layout(binding = 0) uniform sampler2D tones; // before, now
#ifdef ROWS
layout(location = 0) out vec4 sums; // of tones, of their squares
#else
layout(binding = 1) uniform sampler2D row_sums;
layout(location = 0) out vec2 even;

// Deviations that are less are noise of the picture, and stay small.
const float least_deviation = 0.02;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), outermost = textureSize(tones, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int i = -window_reach; i <= window_reach; ++i) {
#ifdef ROWS
        vec2 t = texelFetch(tones, ivec2(clamp(pixel.x + i, 0, outermost.x), pixel.y), 0).rg;
        sum += window[abs(i)] * vec4(t, t * t);
#else
        sum += window[abs(i)] * texelFetch(row_sums, ivec2(pixel.x, clamp(pixel.y + i, 0, outermost.y)), 0);
#endif
    }
#ifdef ROWS
    sums = sum;
#else
    vec2 variance = max(sum.zw - sum.xy * sum.xy, 0.0);
    even = (texelFetch(tones, pixel, 0).rg - sum.xy) / sqrt(variance + least_deviation * least_deviation);
#endif
}
