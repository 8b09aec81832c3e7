// The patch of a surface that a segment's strokes lie in: straight lines between its two nodes, from rib point to rib
// point. The chain's curve is one within the patch, so that it does not leave the surface.
#include "shade_strokes/data.glsl"
#include "shade_strokes/zigzag.glsl"

// In the world, RIB_POINTS per node; w: which side of the chain the point is on, from -1 to 1.
layout(std430, binding = 2) buffer Ribs { vec4 at[]; }
ribs;

// side: -1 to 1 from the right to the left; v: 0 to 1 from begin to end. Each strip between two lines of rib points is
// ruled, so that a fold that both ribs bend at is one of its rims.
vec3 patch_at(const Seen seen, float side, float v) {
    uint begin = seen.nodes[0] * RIB_POINTS, end = seen.nodes[1] * RIB_POINTS;
    uint k = side < 0.0 ? 1u : 3u;
    if (side <= mix(ribs.at[begin + k].w, ribs.at[end + k].w, v)) --k;
    vec4 right = mix(ribs.at[begin + k], ribs.at[end + k], v);
    vec4 left = mix(ribs.at[begin + k + 1u], ribs.at[end + k + 1u], v);
    return mix(right.xyz, left.xyz, clamp((side - right.w) / (left.w - right.w), 0.0, 1.0));
}

// Where the curve has a place of the straight patch (x: v, y: side): all of it moved in the middle, nothing at the rims.
vec2 on_curve(const Seen seen, vec2 place) {
    float v = place.x, w = 1.0 - v;
    vec2 off = 3.0 * v * w * (w * seen.bend_from + v * seen.bend_to);
    return place + vec2(off.x, off.y * (1.0 - place.y * place.y));
}

// The side of a zigzag's point within the segment. Where two chains were joined the one's zigzag turns into the other's.
float seen_side(const Seen seen, float v, int point) {
    float log_value = mix(seen.log_value[0], seen.log_value[1], v);
    float place = seen.place[0] + v * seen.span;
    float side = side_at(seen.set[0], place, point, log_value);
    if (seen.set[0] == seen.set[1] && seen.place[0] == seen.place[1]) return side;
    float other = seen.place[1] + v * seen.span;
    return mix(side, side_at(seen.set[1], other, point_before(seen.set[1], other), log_value), smoothstep(0.0, 1.0, v));
}
