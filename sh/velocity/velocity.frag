#version 450 core
// Screen motion since the frame before, pixels, of the surface that the depth buffer shows.
#include "common/view.glsl"

layout(binding = 0) uniform sampler2D depth_buffer;

in vec4 now;
in vec4 before;
layout(location = 0) out vec2 out_velocity;

void main() {
    float shown = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    // Other programs may round depths differently in their last bits.
    if (abs(gl_FragCoord.z - shown) > 1e-5 * max(shown, 1e-6) + 1e-9) discard;
    // What was behind the eye has no place on the screen that it came from.
    if (before.w <= 0.0) {
        out_velocity = vec2(0.0);
        return;
    }
    out_velocity = (now.xy / now.w - before.xy / before.w) * 0.5 * viewport;
}
