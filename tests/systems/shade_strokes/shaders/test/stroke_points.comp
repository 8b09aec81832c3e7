#version 450 core
// What strokes.vert makes of each segment: the points of its strokes in the world, as they are drawn, between which
// lines are straight.
#include "shade_strokes/stroke.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 5) readonly buffer SeenSegments { Seen seen[]; }
segments;
// By segment, stroke and point (5 each): the place, and the stroke's part along the segment (v) there.
layout(std430, binding = 6) writeonly buffer Points { vec4 point[]; }
points;

uniform uint segment_count;
uniform int most_strokes; // more are left out

void main() {
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= segment_count) return;
    Seen seen = segments.seen[slot];
    bool bent = (seen.flags & BENT) != 0u;
    for (int s = 0; s < most_strokes; ++s)
        for (int p = 0; p < 5; ++p) {
            uint at = (slot * uint(most_strokes) + uint(s)) * 5u + uint(p);
            points.point[at] = vec4(-1.0);
            if (s >= seen.strokes) continue;
            Stroke stroke = stroke_of(seen, s);
            float x = bent ? crossing(seen, stroke, p) : 0.25 * float(p);
            vec3 place = bent ? on_stroke(seen, stroke, x)
                              : mix(on_stroke(seen, stroke, 0.0), on_stroke(seen, stroke, 1.0), x);
            points.point[at] = vec4(place, mix(stroke.v.x, stroke.v.y, x));
        }
}
