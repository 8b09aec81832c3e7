// Bends the middle of a segment so that its chain is a smooth curve on the surface.
#include "shade_strokes/lie.glsl"

// The tangent of a smooth curve through three places, as a parabola has it: near ones count more.
vec3 tangent(vec3 a, vec3 b, vec3 c, float before, float after) {
    return ((b - a) * (after / before) + (c - b) * (before / after)) / (before + after);
}

const vec2 MOST_BEND = vec2(0.25, 0.6); // keeps a curve from turning back, and strokes in their order across it

// What a tangent asks of a curve's inner point, along the segment and across it. What is normal to the patch is left
// out: the patch is as near the surface as was asked for.
vec2 bend(vec3 tangent_, float length_, vec3 chord, vec3 across) {
    vec3 off = (tangent_ * length_ - chord) / 3.0;
    float a = dot(chord, chord), b = dot(chord, across), c = dot(across, across);
    float square = a * c - b * b;
    if (!(square > 1e-6 * a * c)) return vec2(0.0);
    vec2 to = vec2(dot(off, chord), dot(off, across));
    return clamp(vec2(c * to.x - b * to.y, a * to.y - b * to.x) / square, -MOST_BEND, MOST_BEND);
}

// `beside`: the nodes before and behind the segment's.
void set_bends(Segment s, uint beside[2], float span, float before, float after, inout Seen seen) {
    vec3 from = middle(s.from), to = middle(s.to), chord = to - from;
    vec3 across = 0.25 * (ribs.at[s.from * RIB_POINTS + 4u].xyz - ribs.at[s.from * RIB_POINTS].xyz +
                          ribs.at[s.to * RIB_POINTS + 4u].xyz - ribs.at[s.to * RIB_POINTS].xyz);
    if (seen.free[0] < 1.0)
        seen.bend_from =
            (1.0 - seen.free[0]) * bend(tangent(middle(beside[0]), from, to, before, span), span, chord, across);
    if (seen.free[1] < 1.0)
        seen.bend_to =
            -(1.0 - seen.free[1]) * bend(tangent(from, to, middle(beside[1]), span, after), span, chord, across);
}
