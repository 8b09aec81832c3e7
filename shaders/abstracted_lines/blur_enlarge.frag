#version 450 core
// Back to the full resolution, bilinear.
#include "abstracted_lines/pyramid.glsl"

uniform float part; // a pixel's side in texels

void main() { out_tones = at(part * gl_FragCoord.xy); }
