#version 450 core
// How many stamps may reach a tile.
// Define: TILE, its side in pixels.
#include "implicit_brush/marks.glsl"

uniform ivec2 first; // pixels that may stamp
uniform ivec2 last;
uniform int reach; // px

layout(location = 0) out uint out_stamps;

void main() {
    ivec2 corner = TILE * ivec2(gl_FragCoord.xy);
    ivec2 from = max(corner - reach, first), to = min(corner + TILE - 1 + reach, last);
    int stamps = 0;
    for (int y = from.y; y <= to.y; ++y)
        for (int column = from.x >> 5; column <= to.x >> 5; ++column)
            stamps += bitCount(marks_within(column, y, from.x, to.x));
    out_stamps = uint(stamps);
}
