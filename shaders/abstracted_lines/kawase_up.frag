#version 450 core
// Double the resolution, dual Kawase (Bjorge 2015): the corners of a square and, at half their weight, those of one
// turned by 45 degrees. systems/abstracted_lines/kawase_plan.cpp has its variance.
#include "abstracted_lines/pyramid.glsl"

uniform float offset; // of the turned square's corners, texels of what is doubled

void main() {
    vec2 here = 0.5 * gl_FragCoord.xy, x = vec2(offset, 0.0), y = vec2(0.0, offset), aslant = vec2(0.5, -0.5) * offset;
    out_tones = (at(here + x) + at(here - x) + at(here + y) + at(here - y) +
                 2.0 * (at(here + 0.5 * offset) + at(here - 0.5 * offset) + at(here + aslant) + at(here - aslant))) /
                12.0;
}
