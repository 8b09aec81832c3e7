#version 450 core
// STEPS steps of explicit anisotropic diffusion along one axis (section 3.2.1): each lets neighbours exchange a quarter
// of their difference, if no contour insulates either of them: a variance of 1/2 px^2. All steps of an axis are done at
// once, on the line of pixels that they reach; the other axis follows in its own pass. A step along both moves values by
// a pixel on average (mean square).
#include "implicit_brush/slope_texel.glsl"

uniform ivec2 axis;

layout(location = 0) out vec4 out_slope;

void main() {
    const int LENGTH = 2 * STEPS + 1;
    vec2 u[LENGTH];
    float exchange[LENGTH];
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 here = vec4(0.0);
    float before = 0.0;
    for (int i = 0; i < LENGTH; ++i) {
        vec4 s = slope_at(pixel + (i - STEPS) * axis);
        float after = free(s);
        u[i] = s.rg;
        exchange[i] = 0.25 * min(before, after); // with the one before
        before = after;
        if (i == STEPS) here = s;
    }
    for (int step = 1; step <= STEPS; ++step) {
        vec2 last = u[step - 1];
        for (int i = step; i < LENGTH - step; ++i) {
            vec2 old = u[i];
            u[i] = old + exchange[i + 1] * (u[i + 1] - old) + exchange[i] * (last - old);
            last = old;
        }
    }
    out_slope = vec4(u[STEPS], here.ba);
}
