#version 450 core
// Half the resolution, dual Kawase (Bjorge 2015): the middle of four texels and the corners of a square around it.
// systems/abstracted_lines/kawase_plan.cpp has its variance.
#include "abstracted_lines/pyramid.glsl"

uniform float offset; // of the corners, texels of what is halved

void main() {
    vec2 here = 2.0 * gl_FragCoord.xy;
    out_tones = 0.5 * at(here) + 0.125 * (at(here + offset) + at(here - offset) + at(here + vec2(offset, -offset)) +
                                          at(here + vec2(-offset, offset)));
}
