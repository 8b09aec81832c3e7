// The zigzag that strokes follow along a chain, at any level of detail (Sorman & Hult 2005, sections 2.2.2 and
// 2.3.3.2). The paper gives each segment its own; here a chain has one that goes on over its segments, which may be
// shorter than a stroke: what is measured along it is a "place", in units of the mean distance of points.
#include "shade_strokes/data.glsl"

layout(std430, binding = 3) readonly buffer Tables { vec2 points[]; } // place, side; set after set
tables;

uniform float flicker; // how far points jump aside, over the amplitude
uniform uint tick;     // when

uint set_of(uint random) { return (random >> 8) % 5u; }
float start_of(uint random) { return tables.points[set_of(random) * TABLE_POINTS + random % TABLE_POINTS].x; }

uint mixed(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// Points are numbered on and on over the ends of the table, also below 0.
float point_place(uint set, int point) {
    return float(point & ~(TABLE_POINTS - 1)) + tables.points[set * TABLE_POINTS + (point & (TABLE_POINTS - 1))].x;
}

float point_side(uint set, int point) {
    float side = tables.points[set * TABLE_POINTS + (point & (TABLE_POINTS - 1))].y;
    if (flicker <= 0.0) return side;
    float jump = float(mixed(mixed(uint(point) * 8u + set) + tick)) * (2.0 / 4294967296.0) - 1.0;
    side = abs(side + flicker * jump + 1.0);   // folded back into [-1, 1], so that it stays as evenly spread
    return side <= 2.0 ? side - 1.0 : 3.0 - side;
}

// The last point that is not beyond a place.
int point_before(uint set, float place) {
    float turns = floor(place / float(TABLE_POINTS));
    float rest = place - turns * float(TABLE_POINTS);
    int low = 0;
    for (int step_ = TABLE_POINTS / 2; step_ > 0; step_ /= 2)
        if (tables.points[set * TABLE_POINTS + low + step_].x <= rest) low += step_;
    return int(turns) * TABLE_POINTS + low;
}

// The level of a value: points are 2^level apart, and those between two of the next level have come `t` of the way from
// the straight line between these two. The value runs from half of 2^level, where t is 1, to all of it.
int level_of(float log_value, out float t) {
    float level = ceil(log_value);
    t = 2.0 - 2.0 * exp2(log_value - level);
    return int(level);
}

// How much a point counts: those of the level that the next one leaves out fade into the straight line between others.
float presence(int point, float log_value) {
    float t;
    int level = level_of(log_value, t);
    if ((point & ((1 << level) - 1)) != 0) return 0.0;
    return (point & (1 << level)) != 0 ? t : 1.0;
}

// The side at a place on straight lines between points of a level; `point` is one of any level that is not beyond it.
float side_on_lines(uint set, float place, int point, int level) {
    int low = (point >> level) << level, high = low + (1 << level);
    float from = point_place(set, low), to = point_place(set, high);
    return mix(point_side(set, low), point_side(set, high), clamp((place - from) / max(to - from, 1e-6), 0.0, 1.0));
}

// The side at a place for a value, without a jump in either.
float side_at(uint set, float place, int point, float log_value) {
    float t;
    int level = level_of(log_value, t);
    return mix(side_on_lines(set, place, point, level + 1), side_on_lines(set, place, point, level), t);
}
