// One stroke of a segment that is seen: a straight line in its zigzag, which bends with the surface.
#include "shade_strokes/patch.glsl"

// As part of the segment: where it begins and ends along and across it.
struct Stroke {
    vec2 v, side;
    vec4 part;   // of the way from turn to turn of the zigzag, at its begin and its end: by the level's points, and by
                 // the next level's
    float finer; // how much of the former
    vec2 turn;   // how much the zigzag turns there; 0 where the stroke goes on in the next one
    vec2 taper;  // how much the chain ends there
};

// The parts of the way from point to point of a level that two places have.
vec2 parts_of(uint set, int from, int level, vec2 ends) {
    int low = (from >> level) << level;
    float begin = point_place(set, low), end = point_place(set, low + (1 << level));
    return (ends - begin) / max(end - begin, 1e-6);
}

Stroke stroke_of(const Seen seen, int number) {
    uint set = seen.set[0];
    int stride = 1 << seen.level;
    int to = seen.first + number * stride, from = to - stride;
    vec2 points = vec2(point_place(set, from), point_place(set, to));
    vec2 ends = clamp(points, vec2(seen.place[0]), vec2(seen.place[0] + seen.span));
    bool first = number == 0, last = number == seen.strokes - 1;
    Stroke stroke;
    stroke.v = clamp((ends - seen.place[0]) / seen.span, 0.0, 1.0);
    float middle = value_at(seen, 0.5 * (stroke.v.x + stroke.v.y));
    int level = level_of(middle, stroke.finer);
    level = max(level, seen.level);
    stroke.part = vec4(parts_of(set, from, level, ends), parts_of(set, from, level + 1, ends));
    stroke.taper = vec2(first ? seen.free[0] : 0.0, last ? seen.free[1] : 0.0);
    stroke.turn.x = first ? stroke.taper.x : presence(from, value_at(seen, stroke.v.x));
    stroke.turn.y = last ? stroke.taper.y : presence(to, value_at(seen, stroke.v.y));
    int points_[2] = int[2](first ? point_before(set, ends.x) : from, last ? point_before(set, ends.y) : to);
    stroke.side.x = seen_side(seen, stroke.v.x, points_[0]);
    stroke.side.y = seen_side(seen, stroke.v.y, points_[1]);
    vec2 begin = on_curve(seen, vec2(stroke.v.x, stroke.side.x), points_[0]);
    vec2 end = on_curve(seen, vec2(stroke.v.y, stroke.side.y), points_[1]);
    stroke.v = vec2(begin.x, end.x);
    stroke.side = vec2(begin.y, end.y);
    return stroke;
}

// In the world; x: 0 to 1 from begin to end.
vec3 on_stroke(const Seen seen, const Stroke stroke, float x) {
    return patch_at(seen, mix(stroke.side.x, stroke.side.y, x), mix(stroke.v.x, stroke.v.y, x));
}

// Where a stroke crosses a line between rib points; at one of its ends where it does not.
float crossing_of(const Seen seen, const Stroke stroke, uint k) {
    float begin = ribs.at[seen.nodes[0] * RIB_POINTS + k].w, end = ribs.at[seen.nodes[1] * RIB_POINTS + k].w;
    float line = mix(begin, end, stroke.v.x), turn = (end - begin) * (stroke.v.y - stroke.v.x);
    float closing = stroke.side.y - stroke.side.x - turn;
    return abs(closing) < 1e-6 ? 0.0 : clamp((line - stroke.side.x) / closing, 0.0, 1.0);
}

// Point number p of 0 to 4 of a stroke that bends: where it crosses the three lines, in the order in which it does,
// which is not always theirs: lines run aslant themselves.
float crossing(const Seen seen, const Stroke stroke, int p) {
    if (p == 0 || p == 4) return 0.25 * float(p);
    float a = crossing_of(seen, stroke, 1u), b = crossing_of(seen, stroke, 2u), c = crossing_of(seen, stroke, 3u);
    float low = min(a, min(b, c)), high = max(a, max(b, c));
    return p == 1 ? low : p == 3 ? high : a + b + c - low - high;
}
