#version 450 core
// The Gaussian over every texel within three deviations in both directions: the reference of the other kinds of blur.
// Define: RADIUS.

layout(binding = 0) uniform sampler2D tones;

uniform float weights[RADIUS + 1]; // by distance along an axis; those of both axes multiply
uniform ivec2 first;               // texel that holds a tone
uniform ivec2 last;

layout(location = 0) out vec4 out_tones;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    out_tones = vec4(0.0);
    for (int y = -RADIUS; y <= RADIUS; ++y) {
        vec4 row = vec4(0.0);
        for (int x = -RADIUS; x <= RADIUS; ++x)
            row += weights[abs(x)] * texelFetch(tones, clamp(here + ivec2(x, y), first, last), 0);
        out_tones += weights[abs(y)] * row;
    }
}
