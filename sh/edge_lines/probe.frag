#version 450 core
// How the depth in the window changes from probe to probe, relative to itself so that half floats hold it: a plane's
// depth is linear on the screen, so this is exact over a triangle. The depth itself goes where depth goes.
#include "surface/surface.glsl"

void main() {
    float depth = gl_FragCoord.z;
    vec2 slope = vec2(dFdx(depth), dFdy(depth)) / max(depth, 1e-30);
    surface_color(); // drops what a material's mask cuts out
    out_color = vec4(clamp(slope, -6e4, 6e4), 0.0, 1.0);
}
