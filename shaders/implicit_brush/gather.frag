#version 450 core
// Adds up what reaches a pixel, row by row from the bottom, in a row from the left: as splats are drawn.
// Define: MARKED to go from mark to mark; else every pixel in reach is looked at.
#include "implicit_brush/stamp.glsl"
#include "implicit_brush/tone.glsl"
#include "implicit_brush/marks.glsl"

uniform ivec2 first; // pixels that may stamp
uniform ivec2 last;
uniform int reach; // px

layout(location = 0) out vec4 out_color;

void add(inout SUM sum, ivec2 pixel, ivec2 here) {
    vec4 ink = texelFetch(stamp_inks, pixel, 0);
#ifndef MARKED
    if (!(ink.a > 0.0)) return;
#endif
    vec4 place = place_of(pixel);
#ifndef MARKED
    if (!is_stamp(place, ink.a)) return;
#endif
    sum += stamped(make_stamp(place, ink), pixel, here);
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    SUM sum = SUM(0.0);
    for (int y = max(here.y - reach, first.y); y <= min(here.y + reach, last.y); ++y) {
        int down = y - here.y;
        int chord = int(sqrt(float(reach * reach - down * down)));
        int from = max(here.x - chord, first.x), to = min(here.x + chord, last.x);
#ifdef MARKED
        for (int column = from >> 5; column <= to >> 5; ++column) {
            uint bits = marks_within(column, y, from, to);
            while (bits != 0u) {
                add(sum, ivec2(32 * column + findLSB(bits), y), here);
                bits &= bits - 1u;
            }
        }
#else
        for (int x = from; x <= to; ++x) add(sum, ivec2(x, y), here);
#endif
    }
    out_color = toned(sum, here);
}
