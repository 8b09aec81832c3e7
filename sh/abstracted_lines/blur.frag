#version 450 core
// One direction of a separable Gaussian. Nearest fetches: filtered ones, two weights at a time, cost software renderers
// more than they save.
layout(binding = 0) uniform sampler2D tones;

uniform float weights[RADIUS + 1];
uniform ivec2 along;
uniform ivec2 first; // texels that hold tones
uniform ivec2 last;

layout(location = 0) out vec4 out_tone;

vec4 fetch(ivec2 texel) { return texelFetch(tones, clamp(texel, first, last), 0); }

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 sum = weights[0] * fetch(here);
    for (int i = 1; i <= RADIUS; ++i) sum += weights[i] * (fetch(here - i * along) + fetch(here + i * along));
    out_tone = sum;
}
