#version 450 core
// Which tiles of the picture a line from it can begin in: 1 for each that holds a boundary of objects, a step of depth or
// a turn of normals. Most tiles have none, and what is dear is done in the others alone.
#include "common/view.glsl"
#include "edge_lines/image_breaks.glsl"

uniform float loosest_cosine; // of all objects' creases

layout(location = 0) out float out_tile;

// Along a row or a column of a tile.
bool any_break(ivec2 pixel, ivec2 side) {
    float before = depth_at(pixel - side), here = depth_at(pixel), there = depth_at(pixel + side);
    uvec2 code = code_at(pixel);
    vec3 normal = decode_direction(code.y);
    bool found = false;
    for (int i = 0; i < TILE; ++i) {
        float after = depth_at(pixel + (i + 2) * side);
        uvec2 next = code_at(pixel + (i + 1) * side);
        vec3 next_normal = decode_direction(next.y);
        bool edge = breaks_off(before, here, there, after) || turns(normal, next_normal, loosest_cosine);
        found = found || code.x != next.x || (code.x != 0u && edge);
        before = here, here = there, there = after;
        code = next, normal = next_normal;
    }
    return found;
}

void main() {
    ivec2 first = area.xy + TILE * ivec2(gl_FragCoord.xy);
    bool found = false;
    for (int i = 0; i < TILE && !found; ++i)
        found = any_break(first + ivec2(0, i), ivec2(1, 0)) || any_break(first + ivec2(i, 0), ivec2(0, 1));
    out_tile = found ? 1.0 : 0.0;
}
