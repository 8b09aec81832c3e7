#version 450 core
// Where the surface that the depth buffer shows was when the noise of each phase was made.
#include "common/view.glsl"
#include "implicit_brush/visible.glsl"

uniform vec4 past_view[2]; // pixels across and up, metres of a pixel as View has it
uniform vec4 phase[2];     // random shift, pixels; weight

in vec4 past_clip_0;
in vec4 past_clip_1;

layout(location = 0) out vec4 out_past_0;
layout(location = 1) out vec4 out_past_1;

vec4 past(vec4 clip, vec4 seen, vec4 phase) {
    // What was behind the eye has no place on the screen that it came from.
    if (clip.w <= 0.0) return vec4(0.0);
    float farther = pixel_size / (gl_FragCoord.w * seen.z * clip.w);
    return vec4((0.5 + 0.5 * clip.xy / clip.w) * seen.xy + phase.xy, log2(farther), phase.z);
}

void main() {
    keep_visible();
    out_past_0 = past(past_clip_0, past_view[0], phase[0]);
    out_past_1 = past(past_clip_1, past_view[1], phase[1]);
}
