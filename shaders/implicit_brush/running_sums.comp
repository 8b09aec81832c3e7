#version 450 core
// Replaces each number of a row by the sum of all up to it; a row each.
// Defines: GROUP; CHANNELS of a pixel, which lie beside each other.

layout(local_size_x = GROUP) in;
layout(r32ui, binding = 0) uniform uimage2D sums;

uniform ivec4 painted; // first x, y, last x, y of the pixels that get ink

void main() {
    int channel = int(gl_GlobalInvocationID.x) % CHANNELS;
    int y = painted.y + int(gl_GlobalInvocationID.x) / CHANNELS;
    if (y > painted.w) return;
    uint sum = 0u;
    for (int x = painted.x; x <= painted.z; ++x) {
        ivec2 texel = ivec2(CHANNELS * x + channel, y);
        sum += imageLoad(sums, texel).r;
        imageStore(sums, texel, uvec4(sum));
    }
}
