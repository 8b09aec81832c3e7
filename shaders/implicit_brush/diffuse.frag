#version 450 core
// STEPS steps of explicit anisotropic diffusion along one axis (section 3.2.1): each adds a quarter of what a pixel's two
// neighbours exceed it by, a variance of 1/2 px^2, unless a contour insulates one of the three. All steps of an axis are
// done at once, on the line of pixels that they reach; the other axis follows in its own pass. A step along both moves
// values by a pixel on average (mean square).
//
// Both neighbours or neither: an exchange with the one that is left would level slopes off towards a contour, and since
// slopes grow towards a limb, their change, the curvature, would be greatest a few pixels inside of it: a ridge along
// every outline. This way what is linear stays as it is, up to the contour.
#include "implicit_brush/slope_texel.glsl"

uniform ivec2 axis;

layout(location = 0) out vec4 out_slope;

void main() {
    const int LENGTH = 2 * STEPS + 1;
    vec2 u[LENGTH];
    float share[LENGTH];
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 here = vec4(0.0);
    for (int i = 0; i < LENGTH; ++i) {
        vec4 s = slope_at(pixel + (i - STEPS) * axis);
        u[i] = s.rg;
        share[i] = free(s);
        if (i == STEPS) here = s;
    }
    for (int step = 1; step <= STEPS; ++step) {
        vec2 before = u[step - 1];
        for (int i = step; i < LENGTH - step; ++i) {
            vec2 old = u[i];
            float exchange = 0.25 * min(share[i], min(share[i - 1], share[i + 1]));
            u[i] += exchange * (before - 2.0 * old + u[i + 1]);
            before = old;
        }
    }
    out_slope = vec4(u[STEPS], here.ba);
}
