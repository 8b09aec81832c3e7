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
flat out vec2 turn;                // how much these are ends of the stroke; 0 where it goes on in the next segment
noperspective out vec2 part;       // of the way from turn to turn: by the level's points, and by the next one's
noperspective out float half_width;
flat out float alpha;
flat out float finer;              // how much the level's points count

const float SHORT = 0.2;  // pixels: below that, ends don't tell the direction
const float TAPER = 0.35; // of the width, where a chain ends

vec3 window(vec3 world) {
    vec4 clip = clip_from_world * vec4(world, 1.0);
    return vec3((clip.xy / clip.w * 0.5 + 0.5) * viewport, clip.z / clip.w);
}

// Which way a stroke runs on the screen, unit, by slopes: for one so short that its places do not tell.
vec2 slope_at(const Seen seen, const Stroke stroke, float x) {
    vec2 begin = vec2(stroke.v.x, stroke.side.x), way = vec2(stroke.v.y, stroke.side.y) - begin;
    float size = max(abs(way.x), abs(way.y));
    if (!(size > 0.0)) return vec2(1.0, 0.0);
    vec2 sum = vec2(0.0);
    for (int i = -1; i < 2; i += 2) {
        vec2 at = begin + clamp(x + 0.02 * float(i), 0.0, 1.0) * way;
        vec4 clip = clip_from_world * vec4(patch_at(seen, at.y, at.x), 1.0);
        vec4 slope = clip_from_world * vec4(patch_slope(seen, at, way / size), 0.0);
        vec2 pixels = (slope.xy * clip.w - clip.xy * slope.w) * viewport;
        float length_ = length(pixels);
        if (length_ > 0.0) sum += pixels / length_;
    }
    float length_ = length(sum);
    return length_ > 1e-3 ? sum / length_ : vec2(1.0, 0.0);
}

// Which way one that bends does: from a pixel before to a pixel behind, so that no bend comes or goes at once.
vec2 direction_at(const Seen seen, const Stroke stroke, float x, float length_) {
    float reach = clamp(1.0 / max(length_, 1e-6), 0.02, 1.0);
    vec2 way = window(on_stroke(seen, stroke, min(x + reach, 1.0))).xy -
               window(on_stroke(seen, stroke, max(x - reach, 0.0))).xy;
    float size = length(way);
    return size < SHORT ? slope_at(seen, stroke, x) : way / size;
}

float half_width_at(const Seen seen, const Stroke stroke, float x) {
    float here = mix(seen.half_width[0], seen.half_width[1], mix(stroke.v.x, stroke.v.y, x));
    return here * mix(mix(1.0, TAPER, stroke.taper.x), mix(1.0, TAPER, stroke.taper.y), x);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    center = place = vec3(0.0);
    part = turn = vec2(0.0);
    half_width = alpha = finer = 0.0;
    Seen seen = segments.seen[in_slot];
    bool bent = (seen.flags & BENT) != 0u;
    int column = gl_VertexID / 2, columns = bent ? 5 : 2;
    int number = column / columns, p = column % columns;
    if (number >= seen.strokes) return; // room in the batch that this segment does not need

    Stroke stroke = stroke_of(seen, number);
    float x = bent ? crossing(seen, stroke, p) : float(p);
    vec3 from = window(on_stroke(seen, stroke, 0.0)), to = window(on_stroke(seen, stroke, 1.0));
    vec3 here = bent ? window(on_stroke(seen, stroke, x)) : p == 0 ? from : to;
    float length_ = length(to.xy - from.xy);
    vec2 along = bent              ? direction_at(seen, stroke, x, length_)
                 : length_ < SHORT ? slope_at(seen, stroke, x)
                                   : (to.xy - from.xy) / length_;

    // Ends reach half a pixel out for a smooth rim.
    float out_ = p == 0 ? -0.5 : p == columns - 1 ? 0.5 : 0.0;
    half_width = half_width_at(seen, stroke, x);
    float aside = ((gl_VertexID & 1) != 0 ? 1.0 : -1.0) * (half_width + 0.5);
    center = vec3(here.xy + out_ * along, here.z);
    place = vec3(aside, x * length_ + out_, (1.0 - x) * length_ - out_);
    turn = stroke.turn;
    part = mix(stroke.part.xz, stroke.part.yw, x);
    finer = stroke.finer;
    alpha = seen.alpha;
    vec2 pixel = center.xy + aside * vec2(-along.y, along.x);
    gl_Position = vec4(pixel / viewport * 2.0 - 1.0, 0.0, 1.0);
}
