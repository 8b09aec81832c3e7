#version 450 core
// One direction of a separable Gaussian. Nearest fetches: filtered ones, two weights at a time, cost software renderers
// more than they save. Defines: RADIUS, texels; CHANNELS, 2 or 4; AXIS, 0 along rows, 1 along columns.
layout(binding = 0) uniform sampler2D tones;

uniform float weights[RADIUS + 1];
uniform ivec2 first; // texels that hold tones
uniform ivec2 last;

layout(location = 0) out vec4 out_tone;

#if CHANNELS == 2
#define TONE vec2
#define CHANNELS_OF(texel) texel.rg
#else
#define TONE vec4
#define CHANNELS_OF(texel) texel
#endif

// Only along the axis can a texel lie outside of those that hold tones.
TONE fetch(ivec2 here, int offset) {
    here[AXIS] = clamp(here[AXIS] + offset, first[AXIS], last[AXIS]);
    return CHANNELS_OF(texelFetch(tones, here, 0));
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    TONE sum = weights[0] * fetch(here, 0);
    for (int i = 1; i <= RADIUS; ++i) sum += weights[i] * (fetch(here, -i) + fetch(here, i));
#if CHANNELS == 2
    out_tone = vec4(sum, 0.0, 1.0);
#else
    out_tone = sum;
#endif
}
