// The patch of a surface that a segment's strokes lie in: straight lines between its two nodes, from rib point to rib
// point, all bent alike so that the chain is a smooth curve.
#include "shade_strokes/data.glsl"
#include "shade_strokes/zigzag.glsl"

// In the world, RIB_POINTS per node; w: which side of the chain the point is on, from -1 to 1.
layout(std430, binding = 2) buffer Ribs { vec4 at[]; }
ribs;

vec3 rib_at(uint node, float side) {
    uint first = node * RIB_POINTS + (side < 0.0 ? 0u : 2u);
    if (side > ribs.at[first + 1u].w) ++first;
    vec4 right = ribs.at[first], left = ribs.at[first + 1u];
    return mix(right.xyz, left.xyz, clamp((side - right.w) / (left.w - right.w), 0.0, 1.0));
}

// side: -1 to 1 from the right to the left; v: 0 to 1 from begin to end.
vec3 patch_at(const Seen seen, float side, float v) {
    vec3 flat_ = mix(rib_at(seen.nodes[0], side), rib_at(seen.nodes[1], side), v);
    float w = 1.0 - v;
    return flat_ + 3.0 * v * w * (w * seen.bend_from.xyz + v * seen.bend_to.xyz);
}

// The side of a zigzag's point within the segment. Where two chains were joined the one's zigzag turns into the other's.
float seen_side(const Seen seen, float v, int point) {
    float log_value = mix(seen.bend_from.w, seen.bend_to.w, v);
    float place = seen.place[0] + v * seen.span;
    float side = side_at(seen.set[0], place, point, log_value);
    if (seen.set[0] == seen.set[1] && seen.place[0] == seen.place[1]) return side;
    float other = seen.place[1] + v * seen.span;
    return mix(side, side_at(seen.set[1], other, point_before(seen.set[1], other), log_value), smoothstep(0.0, 1.0, v));
}
