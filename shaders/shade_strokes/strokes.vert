#version 450 core
// One instance per segment that is seen. A stroke is a straight ribbon on the screen along the surface, four vertices
// each; where it bends with the surface, four of them from rib point to rib point.
#include "common/view.glsl"
#include "shade_strokes/stroke.glsl"

layout(location = 0) in uint in_slot;

layout(std430, binding = 5) readonly buffer SeenSegments { Seen seen[]; }
segments;

noperspective out vec3 center;     // of the line: pixels, and depth in the window
noperspective out vec3 place;      // pixels aside of it, and to its two ends
noperspective out vec2 lean;       // metres that what the stroke is on comes nearer over metres aside
flat out vec2 beyond;              // pixels by which the line goes on before and behind, up to 1
noperspective out vec2 part;       // of the way from turn to turn: by the level's points, and by the next one's
noperspective out float half_width;
noperspective out vec2 taper;      // of the way from a chain's ends to where strokes are as wide as that
flat out vec2 free;                // how much the chain ends there
flat out float alpha;
flat out float finer;              // how much the level's points count

uniform float front; // -1 where the transform mirrors, else 1

const int PIECES = 4;            // of a stroke that bends
const float SHORT = 0.2;         // pixels: below that, ends don't tell the direction
const float LEAST_RIMMED = 1.0;  // pixels of two pieces, that they may end at one rim
const float FAR = 2.0;           // pixels: nothing of a pixel is so far from its middle
const float LEAST_FACING = 0.02; // of a surface as good as edge on: sine of its angle with the line of sight

vec3 window(vec3 world) {
    vec4 clip = clip_from_world * vec4(world, 1.0);
    return vec3((clip.xy / clip.w * 0.5 + 0.5) * viewport, clip.z / clip.w);
}

// How the plane that a stroke's patch is nearly in leans, as if edge on where it looks away: metres that it comes
// nearer over metres that one goes aside.
vec2 lean_at(const Seen seen, float v, vec3 here) {
    uint begin = seen.nodes[0] * RIB_POINTS, end = seen.nodes[1] * RIB_POINTS, last = RIB_POINTS - 1;
    vec3 along = ribs.at[end + last / 2].xyz - ribs.at[begin + last / 2].xyz;
    vec3 across = mix(ribs.at[begin + last].xyz - ribs.at[begin].xyz, ribs.at[end + last].xyz - ribs.at[end].xyz, v);
    vec3 normal = front * cross(along, across);
    float length_ = length(normal);
    if (!(length_ > 0.0)) return vec2(0.0);
    normal = mat3(view_from_world) * (normal / length_);
    vec3 place = (view_from_world * vec4(here, 1.0)).xyz;
    vec3 sight = eye.w > 0.0 ? place / -place.z : vec3(0.0, 0.0, -1.0);
    return -normal.xy / max(-dot(normal, sight), LEAST_FACING);
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

// How two ways on the screen meet: across their rim, over half the width; 0 where they are short, or turn too much for
// that. Two ribbons that end at one rim draw no pixel twice, which is what it is for.
vec2 rim_of(vec2 a, vec2 b, float half_) {
    float lengths[2] = float[2](length(a), length(b)), shorter = min(lengths[0], lengths[1]);
    if (shorter < LEAST_RIMMED) return vec2(0.0);
    a /= lengths[0];
    b /= lengths[1];
    float cosine = dot(a, b), sine = a.x * b.y - a.y * b.x;
    if (cosine < 0.9 || half_ * abs(sine) > 0.5 * shorter * (1.0 + cosine)) return vec2(0.0);
    vec2 middle = (a + b) / (1.0 + cosine);
    return vec2(-middle.y, middle.x);
}

// Where a place is on the way from a chain's ends to where strokes are as wide as they get, which is about one of them
// long; the same place whatever strokes it is in, since these come and go with the level of detail.
vec2 taper_at(const Seen seen, float v) {
    vec2 value = vec2(seen.log_value[0], seen.log_value[1]);
    return vec2(v, 1.0 - v) / clamp(2.0 * exp2(value) / seen.span, 1e-3, 1.0);
}

// A straight piece of a stroke, by its two ends.
struct Piece {
    vec2 x;         // of the way along the stroke
    vec3 at[2];     // in the world
    vec3 window[2];
    vec2 along;     // unit, on the screen
    float length_;  // pixels
    vec2 v, half_;  // of the segment; half the line's width, pixels
    vec2 rim[2];    // that it shares with the next piece; 0 where it has none
};

vec2 screen_at(const Seen seen, const Stroke stroke, int point) {
    return window(on_stroke(seen, stroke, crossing(seen, stroke, point))).xy;
}

Piece piece_of(const Seen seen, const Stroke stroke, int number, bool bent) {
    Piece piece;
    piece.x = bent ? vec2(crossing(seen, stroke, number), crossing(seen, stroke, number + 1)) : vec2(0.0, 1.0);
    for (int i = 0; i < 2; ++i) {
        piece.at[i] = on_stroke(seen, stroke, piece.x[i]);
        piece.window[i] = window(piece.at[i]);
        piece.rim[i] = vec2(0.0);
    }
    vec2 way = piece.window[1].xy - piece.window[0].xy;
    piece.length_ = length(way);
    piece.along =
        piece.length_ < SHORT ? slope_at(seen, stroke, 0.5 * (piece.x[0] + piece.x[1])) : way / piece.length_;
    piece.v = mix(vec2(stroke.v.x), vec2(stroke.v.y), piece.x);
    piece.half_ = mix(vec2(seen.half_width[0]), vec2(seen.half_width[1]), piece.v);
    vec2 ribbon = piece.half_ + 0.5;
    if (bent && number > 0)
        piece.rim[0] = rim_of(piece.window[0].xy - screen_at(seen, stroke, number - 1), way, ribbon[0]);
    if (bent && number + 1 < PIECES)
        piece.rim[1] = rim_of(way, screen_at(seen, stroke, number + 2) - piece.window[1].xy, ribbon[1]);
    return piece;
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    center = place = vec3(0.0);
    part = beyond = taper = free = lean = vec2(0.0);
    half_width = alpha = finer = 0.0;
    Seen seen = segments.seen[in_slot];
    bool bent = (seen.flags & BENT) != 0u;
    int ribbon = gl_VertexID / 4, pieces = bent ? PIECES : 1;
    int number = ribbon / pieces, part_number = ribbon % pieces;
    if (number >= seen.strokes) return; // room in the batch that this segment does not need

    Stroke stroke = stroke_of(seen, number);
    Piece piece = piece_of(seen, stroke, part_number, bent);
    if (!(piece.x[1] > piece.x[0])) return;
    bvec2 rimmed = bvec2(piece.rim[0] != vec2(0.0), piece.rim[1] != vec2(0.0));
    bvec2 outer = equal(ivec2(part_number, part_number + 1), ivec2(0, pieces));
    beyond = mix(1.0 - mix(vec2(0.0), stroke.turn, outer), vec2(0.0), rimmed);

    // Without a rim an end reaches half a pixel out: to be smooth, and over the piece that the line goes on in.
    int end = (gl_VertexID & 2) >> 1;
    float out_ = rimmed[end] ? 0.0 : 0.5;
    float at = end == 0 ? -out_ : piece.length_ + out_;
    half_width = piece.half_[end];
    float aside = ((gl_VertexID & 1) != 0 ? 1.0 : -1.0) * (half_width + 0.5);
    vec2 across = rimmed[end] ? piece.rim[end] : vec2(-piece.along.y, piece.along.x);
    center = vec3(piece.window[0].xy + at * piece.along, piece.window[end].z);
    place = vec3(aside, vec2(at, piece.length_ - at) + mix(vec2(0.0), vec2(FAR), rimmed));
    taper = taper_at(seen, piece.v[end]);
    free = vec2(seen.free[0], seen.free[1]);
    lean = lean_at(seen, piece.v[end], piece.at[end]);
    part = mix(stroke.part.xz, stroke.part.yw, piece.x[end]);
    finer = stroke.finer;
    alpha = seen.alpha;
    vec2 pixel = center.xy + aside * across;
    gl_Position = vec4(pixel / viewport * 2.0 - 1.0, 0.0, 1.0);
}
