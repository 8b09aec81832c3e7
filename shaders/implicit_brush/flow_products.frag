#version 450 core
// Terms of the least squares at a pixel: products of the tone's slope g and of what is left of its change d when the
// picture before is moved by the motion known so far.
#include "implicit_brush/flow.glsl"

layout(binding = 0) uniform sampler2D tones; // before, now
layout(binding = 1) uniform sampler2D flow;

layout(location = 0) out vec4 slopes;  // g.x^2, g.x g.y, g.y^2, g.x
layout(location = 1) out vec4 changes; // g.x d, g.y d, d, g.y
layout(location = 2) out float weight; // 0 for what came into the picture, which was nowhere before

// 3x3, by Scharr's weights: its direction errs little whatever that is.
vec2 slope_now(ivec2 pixel) {
    ivec2 outermost = textureSize(tones, 0) - 1;
    float t[9];
    for (int i = 0; i < 9; ++i)
        t[i] = texelFetch(tones, clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), outermost), 0).g;
    return vec2(3.0 * (t[2] - t[0] + t[8] - t[6]) + 10.0 * (t[5] - t[3]),
                3.0 * (t[6] - t[0] + t[8] - t[2]) + 10.0 * (t[7] - t[1])) / 32.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 g = slope_now(pixel);
    vec2 from = gl_FragCoord.xy - known_flow(flow);
    float d = between_texels(tones, from).r - texelFetch(tones, pixel, 0).g;
    // Along the edges neither slope nor place is sure.
    vec2 size = vec2(textureSize(tones, 0));
    vec2 inside = min(min(gl_FragCoord.xy, size - gl_FragCoord.xy), min(from, size - from));
    bool known = min(inside.x, inside.y) > 1.0;
    weight = known ? 1.0 : 0.0;
    slopes = weight * vec4(g.x * g.x, g.x * g.y, g.y * g.y, g.x);
    changes = weight * vec4(g * d, d, g.y);
}
