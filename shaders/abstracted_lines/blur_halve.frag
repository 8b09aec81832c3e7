#version 450 core
// Half the resolution by weights 1, 3, 3, 1 along each axis, a variance of .75 square texels: four bilinear samples,
// each three quarters of a texel from the middle.
#include "abstracted_lines/pyramid.glsl"

void main() {
    vec2 here = 2.0 * gl_FragCoord.xy;
    out_tones = 0.25 * (at(here + 0.75) + at(here - 0.75) + at(here + vec2(0.75, -0.75)) + at(here + vec2(-0.75, 0.75)));
}
