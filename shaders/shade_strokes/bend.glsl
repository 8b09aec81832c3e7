// Bends the middle of a segment so that its chain is a smooth curve on the surface.
#include "shade_strokes/lie.glsl"

// The tangent of a smooth curve through three places, as a parabola has it: near ones count more.
vec3 tangent(vec3 a, vec3 b, vec3 c, float before, float after) {
    return ((b - a) * (after / before) + (c - b) * (before / after)) / (before + after);
}

// Bends the chain so that it is smooth, but within the surface: its normal part is left out, since the straight patch
// is as near the surface as was asked for.
vec3 bend(vec3 tangent_, float length_, vec3 chord, vec3 normal) {
    vec3 off = (tangent_ * length_ - chord) / 3.0;
    off -= dot(off, normal) * normal;
    float most = 0.25 * length(chord), size = length(off);
    return size > most ? off * (most / size) : off;
}

void set_bends(Segment s, float span, float before, float after, inout Seen seen) {
    vec3 from = middle(s.from), to = middle(s.to), chord = to - from;
    vec3 across = ribs.at[s.from * RIB_POINTS + 4u].xyz - ribs.at[s.from * RIB_POINTS].xyz +
                  ribs.at[s.to * RIB_POINTS + 4u].xyz - ribs.at[s.to * RIB_POINTS].xyz;
    vec3 normal = cross(chord, across);
    float size = length(normal);
    if (!(size > 0.0)) return;
    normal /= size;
    if (s.before != s.from)
        seen.bend_from.xyz = bend(tangent(middle(s.before), from, to, before, span), span, chord, normal);
    if (s.after != s.to)
        seen.bend_to.xyz = -bend(tangent(from, to, middle(s.after), span, after), span, chord, normal);
}
