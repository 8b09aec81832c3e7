// Drops what is behind what the depth buffer shows. Programs may round depths differently in their last bits.
layout(binding = 0) uniform sampler2D depth_buffer;

void keep_visible() {
    float shown = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    if (abs(gl_FragCoord.z - shown) > 1e-5 * max(shown, 1e-6) + 1e-9) discard;
}
