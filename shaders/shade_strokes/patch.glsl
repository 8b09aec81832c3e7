// The patch of a surface that a segment's strokes lie in: straight lines between its two nodes, from rib point to rib
// point. The chain's curve is one within the patch, so that it does not leave the surface.
#include "shade_strokes/data.glsl"
#include "shade_strokes/zigzag.glsl"

// In the world, RIB_POINTS per node; w: which side of the chain the point is on, from -1 to 1.
layout(std430, binding = 2) buffer Ribs { vec4 at[]; }
ribs;

// One of the strips between two lines of rib points, at v. Each is ruled, so that a fold that both ribs bend at is one
// of its rims.
struct Strip {
    vec4 right, left;             // its rims here; w: side
    vec4 right_slope, left_slope; // how they change with v
};

// side: -1 to 1 from the right to the left; v: 0 to 1 from begin to end.
Strip strip_at(const Seen seen, float side, float v) {
    uint begin = seen.nodes[0] * RIB_POINTS, end = seen.nodes[1] * RIB_POINTS;
    uint k = side < 0.0 ? 1u : 3u;
    if (side <= mix(ribs.at[begin + k].w, ribs.at[end + k].w, v)) --k;
    Strip strip;
    strip.right_slope = ribs.at[end + k] - ribs.at[begin + k];
    strip.left_slope = ribs.at[end + k + 1u] - ribs.at[begin + k + 1u];
    strip.right = mix(ribs.at[begin + k], ribs.at[end + k], v);
    strip.left = mix(ribs.at[begin + k + 1u], ribs.at[end + k + 1u], v);
    return strip;
}

float across_strip(const Strip strip, float side) {
    return clamp((side - strip.right.w) / (strip.left.w - strip.right.w), 0.0, 1.0);
}

vec3 patch_at(const Seen seen, float side, float v) {
    Strip strip = strip_at(seen, side, v);
    return mix(strip.right.xyz, strip.left.xyz, across_strip(strip, side));
}

// How the place on the patch changes where v and side change by `way`. From differences of rib points, since strokes
// can be shorter than places can tell.
vec3 patch_slope(const Seen seen, vec2 at, vec2 way) {
    Strip strip = strip_at(seen, at.y, at.x);
    float t = across_strip(strip, at.y);
    vec4 along = mix(strip.right_slope, strip.left_slope, t) * way.x;
    return along.xyz + (strip.left.xyz - strip.right.xyz) * ((way.y - along.w) / (strip.left.w - strip.right.w));
}

float value_at(const Seen seen, float v) { return mix(seen.log_value[0], seen.log_value[1], v); }

// How far the chain's curve moves a point of the zigzag, as part of the segment along and across it: nothing at its
// ends and at its rims.
vec2 curve_at(const Seen seen, int point) {
    float v = (point_place(seen.set[0], point) - seen.place[0]) / seen.span, w = 1.0 - v;
    if (v <= 0.0 || v >= 1.0) return vec2(0.0);
    float side = point_side(seen.set[0], point);
    return 3.0 * v * w * (w * seen.bend_from + v * seen.bend_to) * vec2(1.0, 1.0 - side * side);
}

// The same at a place on straight lines between points of a level.
vec2 curve_on_lines(const Seen seen, float place, int point, int level) {
    int low = (point >> level) << level, high = low + (1 << level);
    float begin = max(point_place(seen.set[0], low), seen.place[0]);
    float end = min(point_place(seen.set[0], high), seen.place[0] + seen.span);
    return mix(curve_at(seen, low), curve_at(seen, high), clamp((place - begin) / max(end - begin, 1e-6), 0.0, 1.0));
}

// Where the curve has a place of the straight patch (x: v, y: side), without a jump where the level changes.
vec2 on_curve(const Seen seen, vec2 at, int point) {
    if (seen.bend_from == vec2(0.0) && seen.bend_to == vec2(0.0)) return at;
    float t, place = seen.place[0] + at.x * seen.span;
    int level = level_of(value_at(seen, at.x), t);
    return at + mix(curve_on_lines(seen, place, point, level + 1), curve_on_lines(seen, place, point, level), t);
}

// The side of a zigzag's point within the segment. Where two chains were joined the one's zigzag turns into the
// other's.
float seen_side(const Seen seen, float v, int point) {
    float log_value = value_at(seen, v);
    float place = seen.place[0] + v * seen.span;
    float side = side_at(seen.set[0], place, point, log_value);
    if (seen.set[0] == seen.set[1] && seen.place[0] == seen.place[1]) return side;
    float other = seen.place[1] + v * seen.span;
    return mix(side, side_at(seen.set[1], other, point_before(seen.set[1], other), log_value), smoothstep(0.0, 1.0, v));
}
