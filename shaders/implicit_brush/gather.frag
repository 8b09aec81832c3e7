#version 450 core
// Adds up what reaches a pixel, row by row from the bottom, in a row from the left: as splats are drawn.
// Defines: MARKED to go from mark to mark, else every pixel in reach is looked at; BLOCK, the side of the blocks of pixels
// that then look at the same ones.
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

#ifdef MARKED
// Marks near the pixel's block, the same for all of its pixels: so those that run together take the same way.
SUM add_marked(ivec2 here) {
    SUM sum = SUM(0.0);
    ivec2 low = here & ~(BLOCK - 1), high = low + BLOCK - 1;
    for (int y = max(low.y - reach, first.y); y <= min(high.y + reach, last.y); ++y) {
        int away = max(max(low.y - y, y - high.y), 0);
        int chord = int(sqrt(float(reach * reach - away * away)));
        int from = max(low.x - chord, first.x), to = min(high.x + chord, last.x);
        for (int column = from >> 5; column <= to >> 5; ++column) {
            uint bits = marks_within(column, y, from, to);
            while (bits != 0u) {
                add(sum, ivec2(32 * column + findLSB(bits), y), here);
                bits &= bits - 1u;
            }
        }
    }
    return sum;
}

#else
SUM add_all(ivec2 here) {
    SUM sum = SUM(0.0);
    for (int y = max(here.y - reach, first.y); y <= min(here.y + reach, last.y); ++y) {
        int away = y - here.y;
        int chord = int(sqrt(float(reach * reach - away * away)));
        int from = max(here.x - chord, first.x), to = min(here.x + chord, last.x);
        for (int x = from; x <= to; ++x) add(sum, ivec2(x, y), here);
    }
    return sum;
}

#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef MARKED
    SUM sum = add_marked(here);
#else
    SUM sum = add_all(here);
#endif
    out_color = toned(sum, here);
}
