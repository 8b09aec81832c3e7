#version 450 core
// One instance per segment that is seen; two vertices for each end of a stroke, and where it bends with the surface for
// each rib that it crosses. A stroke is a ribbon on the screen along the surface.
#include "common/view.glsl"
#include "shade_strokes/stroke.glsl"

layout(location = 0) in uint in_slot;

layout(std430, binding = 5) readonly buffer SeenSegments { Seen seen[]; }
segments;

noperspective out vec3 center;     // of the line: pixels, and depth in the window
noperspective out vec3 place;      // pixels aside of it, and to its two ends
noperspective out float part;      // of the way from turn to turn
noperspective out float half_width;
flat out float alpha;

const float TAPER = 0.35; // of the width, where a chain ends

vec3 window(vec3 world) {
    vec4 clip = clip_from_world * vec4(world, 1.0);
    return vec3((clip.xy / clip.w * 0.5 + 0.5) * viewport, clip.z / clip.w);
}

float half_width_at(const Seen seen, const Stroke stroke, float x) {
    float here = mix(seen.half_width[0], seen.half_width[1], mix(stroke.v.x, stroke.v.y, x));
    return here * mix(stroke.taper.x ? TAPER : 1.0, stroke.taper.y ? TAPER : 1.0, x);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    center = place = vec3(0.0);
    part = half_width = alpha = 0.0;
    Seen seen = segments.seen[in_slot];
    bool bent = (seen.flags & BENT) != 0u;
    int column = gl_VertexID / 2, columns = bent ? 5 : 2;
    int number = column / columns, p = column % columns;
    if (number >= seen.strokes) return; // room in the batch that this segment does not need

    Stroke stroke = stroke_of(seen, number);
    float x = bent ? crossing(seen, stroke, p) : float(p);
    vec3 from = window(on_stroke(seen, stroke, 0.0)), to = window(on_stroke(seen, stroke, 1.0));
    vec3 here = bent ? window(on_stroke(seen, stroke, x)) : p == 0 ? from : to;
    vec2 along = to.xy - from.xy;
    float length_ = length(along);
    if (bent)
        along = window(on_stroke(seen, stroke, min(x + 0.02, 1.0))).xy -
                window(on_stroke(seen, stroke, max(x - 0.02, 0.0))).xy;
    float size = length(along);
    along = size > 1e-5 ? along / size : vec2(1.0, 0.0);

    // Ends reach half a pixel out for a smooth rim, but where the stroke goes on in the next segment.
    bool first = p == 0, last = p == columns - 1;
    float out_ = first && !stroke.cut.x ? -0.5 : last && !stroke.cut.y ? 0.5 : 0.0;
    half_width = half_width_at(seen, stroke, x);
    float aside = ((gl_VertexID & 1) != 0 ? 1.0 : -1.0) * (half_width + 0.5);
    center = vec3(here.xy + out_ * along, here.z);
    place = vec3(aside, x * length_ + out_ + (stroke.cut.x ? 1.0 : 0.0),
                 (1.0 - x) * length_ - out_ + (stroke.cut.y ? 1.0 : 0.0));
    part = mix(stroke.part.x, stroke.part.y, x);
    alpha = seen.alpha;
    vec2 pixel = center.xy + aside * vec2(-along.y, along.x);
    gl_Position = vec4(pixel / viewport * 2.0 - 1.0, 0.0, 1.0);
}
