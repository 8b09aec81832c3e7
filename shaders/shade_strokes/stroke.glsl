// One stroke of a segment that is seen: a straight line in its zigzag, which bends with the surface.
#include "shade_strokes/patch.glsl"

// As part of the segment: where it begins and ends along and across it.
struct Stroke {
    vec2 v, side;
    vec2 part;   // of the way from turn to turn of the zigzag that is within the segment
    bvec2 cut;   // whether the stroke goes on in the segment next to this
    bvec2 taper; // whether the chain ends here
};

Stroke stroke_of(const Seen seen, int number) {
    uint set = seen.set[0];
    int stride = 1 << seen.level;
    int to = seen.first + number * stride, from = to - stride;
    vec2 points = vec2(point_place(set, from), point_place(set, to));
    vec2 ends = clamp(points, vec2(seen.place[0]), vec2(seen.place[0] + seen.span));
    bool first = number == 0, last = number == seen.strokes - 1;
    Stroke stroke;
    stroke.v = clamp((ends - seen.place[0]) / seen.span, 0.0, 1.0);
    stroke.part = (ends - points.x) / max(points.y - points.x, 1e-6);
    stroke.taper = bvec2(first && (seen.flags & FREE_BEGIN) != 0u, last && (seen.flags & FREE_END) != 0u);
    stroke.cut = bvec2(first && !stroke.taper.x, last && !stroke.taper.y);
    stroke.side.x = seen_side(seen, stroke.v.x, first ? point_before(set, ends.x) : from);
    stroke.side.y = seen_side(seen, stroke.v.y, last ? point_before(set, ends.y) : to);
    vec2 begin = on_curve(seen, vec2(stroke.v.x, stroke.side.x)), end = on_curve(seen, vec2(stroke.v.y, stroke.side.y));
    stroke.v = vec2(begin.x, end.x);
    stroke.side = vec2(begin.y, end.y);
    return stroke;
}

// In the world; x: 0 to 1 from begin to end.
vec3 on_stroke(const Seen seen, const Stroke stroke, float x) {
    return patch_at(seen, mix(stroke.side.x, stroke.side.y, x), mix(stroke.v.x, stroke.v.y, x));
}

// Point number p of 0 to 4 of a stroke that bends: where it crosses the lines between rib points, in the order in which
// it does.
float crossing(const Seen seen, const Stroke stroke, int p) {
    float away = stroke.side.y - stroke.side.x;
    if (p == 0 || p == 4) return 0.25 * float(p);
    uint k = uint(away > 0.0 ? p : 4 - p);
    float begin = ribs.at[seen.nodes[0] * RIB_POINTS + k].w, end = ribs.at[seen.nodes[1] * RIB_POINTS + k].w;
    float line = mix(begin, end, stroke.v.x), turn = (end - begin) * (stroke.v.y - stroke.v.x);
    return abs(away - turn) < 1e-4 ? 0.25 * float(p) : clamp((line - stroke.side.x) / (away - turn), 0.0, 1.0);
}
