#version 450 core
// Writes the list of stamps: those of a texel of marks from where it starts.

layout(local_size_x = LIST_GROUP) in;

layout(binding = 2) uniform usampler2D marks;
layout(binding = 3) uniform usampler2D starts;
layout(r32ui, binding = 0) uniform writeonly uimage2D stamp_list; // x in the lower half, y in the upper one

uniform ivec4 mark_area; // x, y, width, height of what was marked, texels

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= mark_area.z * mark_area.w) return;
    ivec2 texel = mark_area.xy + ivec2(index % mark_area.z, index / mark_area.z);
    uint bits = texelFetch(marks, texel, 0).r;
    int place = int(texelFetch(starts, texel, 0).r), columns = imageSize(stamp_list).x;
    while (bits != 0u) {
        uint x = uint(32 * texel.x + findLSB(bits));
        bits &= bits - 1u;
        imageStore(stamp_list, ivec2(place % columns, place / columns), uvec4(x | uint(texel.y) << 16));
        ++place;
    }
}
