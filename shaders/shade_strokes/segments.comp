#version 450 core
// What this view sees of each segment: whether anything, at which level of detail, and how wide its strokes are.
#include "common/view.glsl"
#include "shade_strokes/batches.glsl"
#include "shade_strokes/ink.glsl"
#include "shade_strokes/patch.glsl"

layout(local_size_x = GROUP) in;

layout(std430, binding = 0) readonly buffer Segments { Segment segment[]; }
segments;
layout(std430, binding = 1) readonly buffer Nodes { Node node[]; }
nodes;
layout(std430, binding = 4) readonly buffer Delivered { float shade[]; } // by cell
delivered;
layout(std430, binding = 5) writeonly buffer SeenSegments { Seen seen[]; }
seen_segments;
layout(std430, binding = 6) writeonly buffer Counts { uint count[]; } // by group and batch
counts;

uniform uint segment_count;
uniform float unit;        // of zigzags, in the mesh's units
uniform float world_scale; // metres that one of the mesh's units is in the world
uniform float front;       // -1 where the transform mirrors, else 1
uniform float line_width;  // pixels, that strokes are to have where there is little shade
uniform bool solid;        // strokes get thinner, not fainter

const float MOST_WIDTH = 4.0;        // times line_width
const float LOG_VALUES[2] = float[2](-0.999, 6.0); // all points of the table are used, or every 64th
const float BEND_PIXELS = 0.25;      // that make strokes bend

shared uint in_batch[BATCHES];

vec3 middle(uint n) { return ribs.at[n * RIB_POINTS + 2].xyz; }

// False where it is not before the eye.
bool project(vec3 world, out vec2 pixel) {
    vec4 clip = clip_from_world * vec4(world, 1.0);
    pixel = (clip.xy / clip.w * 0.5 + 0.5) * viewport;
    return clip.w > 1e-6 && clip.z <= clip.w;
}

// Length at rest, in the mesh's units. Between chains that were joined counts do not agree, and the straight line does.
float rest_length(uint a, uint b) {
    float chord = distance(middle(a), middle(b)) / world_scale;
    float along = nodes.node[b].along - nodes.node[a].along;
    bool counted = nodes.node[a].random == nodes.node[b].random && along > 0.25 * chord && along < 4.0 * chord;
    return max(counted ? along : chord, 1e-9);
}

// How the surface lies on the screen at a node.
struct Lie {
    vec2 along;  // pixels of one unit of a zigzag
    vec2 across; // pixels from the middle to the left
    float log_value;
};

bool lie_at(uint left_node, uint node, uint right_node, float length_, out Lie lie) {
    vec2 from, to, right, left;
    bool ok = project(middle(left_node), from);
    ok = project(middle(right_node), to) && ok;
    ok = project(ribs.at[node * RIB_POINTS].xyz, right) && ok;
    ok = project(ribs.at[node * RIB_POINTS + 4u].xyz, left) && ok;
    lie.along = (to - from) * (unit / length_);
    lie.across = 0.5 * (left - right);
    return ok;
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// The level of detail's value for which strokes are so far apart, across themselves, that lines of `line_width` have
// the ink that little shade needs. At a value of 1 points of the zigzag that count are 2 units apart.
float log_value(Lie lie) {
    float reach = length(lie.across);
    float apart = reach > 1e-4 ? abs(cross2(lie.across, lie.along)) / reach : length(lie.along);
    float wanted = line_width / (3.0 * density * darkness);
    return clamp(log2(wanted / max(2.0 * apart, 1e-6)), LOG_VALUES[0], LOG_VALUES[1]);
}

// For which strokes have the ink per area that the cell's shade needs: area of the zigzag over length of its lines.
float half_width(Lie lie, float shade) {
    float t;
    float apart = exp2(float(level_of(lie.log_value, t)));
    float area = 2.0 * abs(cross2(lie.across, lie.along)) * apart;
    float line = mean_stroke(length(lie.across), length(lie.along) * apart, t);
    return 0.5 * min(density * ink_of_shade(shade) * area / max(line, 1e-6), MOST_WIDTH * line_width);
}

// The sine of the angle by which the surface looks towards the eye, where it does most.
float facing(uint from, uint to) {
    vec3 along = middle(to) - middle(from);
    float most = -1.0;
    for (int i = 0; i < 2; ++i) {
        uint n = i == 0 ? from : to;
        for (int k = 0; k + 1 < RIB_POINTS; ++k) {
            vec3 right = ribs.at[n * RIB_POINTS + k].xyz;
            vec3 normal = cross(along, ribs.at[n * RIB_POINTS + k + 1].xyz - right);
            float size = length(normal);
            if (size > 0.0) most = max(most, front * dot(normal, towards_eye(right)) / size);
        }
    }
    return most;
}

// Whether a patch is outside the picture, and whether it bends on the screen.
void look_at_patch(uint from, uint to, float margin, out bool outside, out bool bent) {
    vec2 low = vec2(1e30), high = vec2(-1e30);
    bent = false;
    for (int i = 0; i < 2; ++i) {
        uint n = i == 0 ? from : to;
        vec2 at[RIB_POINTS];
        for (int k = 0; k < RIB_POINTS; ++k) {
            project(ribs.at[n * RIB_POINTS + k].xyz, at[k]);
            low = min(low, at[k]);
            high = max(high, at[k]);
        }
        for (int k = 1; k + 1 < RIB_POINTS; ++k)
            bent = bent || distance(at[k], mix(at[0], at[4], 0.5 + 0.5 * ribs.at[n * RIB_POINTS + k].w)) > BEND_PIXELS;
    }
    outside = any(lessThan(high, vec2(-margin))) || any(greaterThan(low, viewport + margin));
}

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

// Where the segment is in its zigzag, or zigzags, and which points of it that are.
void set_places(Segment s, float span, inout Seen seen) {
    uint random[2] = uint[2](nodes.node[s.from].random, nodes.node[s.to].random);
    seen.span = span / unit;
    seen.place[0] = start_of(random[0]) + nodes.node[s.from].along / unit;
    seen.place[1] = start_of(random[1]) + nodes.node[s.to].along / unit - seen.span;
    seen.set = uint[2](set_of(random[0]), set_of(random[1]));
    if (random[0] == random[1] && abs(seen.place[1] - seen.place[0]) < 0.01 + 1e-3 * seen.span)
        seen.place[1] = seen.place[0];
    float t;
    seen.level = level_of(min(seen.bend_from.w, seen.bend_to.w), t);
    int begin = point_before(seen.set[0], seen.place[0]);
    int end = point_before(seen.set[0], seen.place[0] + seen.span);
    while ((end >> seen.level) - (begin >> seen.level) >= MOST_STROKES) ++seen.level;
    seen.first = ((begin >> seen.level) + 1) << seen.level;
    seen.strokes = (end >> seen.level) - (begin >> seen.level) + 1;
}

// False where nothing of it can be seen.
bool look(Segment s, out Seen seen) {
    seen = Seen(vec4(0.0), vec4(0.0), float[2](0.0, 0.0), float[2](0.0, 0.0), 0.0, 0.0, uint[2](0u, 0u),
                uint[2](s.from, s.to), 0, 0, 0, 0u, 0u, 0u);
    if (s.cell == NONE || !(s.alpha > 0.0)) return false;
    bool outside, bent;
    look_at_patch(s.from, s.to, MOST_WIDTH * line_width + 1.0, outside, bent);
    seen.alpha = smoothstep(-0.1, 0.0, facing(s.from, s.to)) * s.alpha;
    if (outside || !(seen.alpha > 0.0)) return false;

    float span = rest_length(s.from, s.to);
    float before = s.before != s.from ? rest_length(s.before, s.from) : 0.0;
    float after = s.after != s.to ? rest_length(s.to, s.after) : 0.0;
    Lie begin, end;
    if (!lie_at(s.before, s.from, s.to, before + span, begin) || !lie_at(s.from, s.to, s.after, span + after, end))
        return false;
    seen.bend_from.w = begin.log_value = log_value(begin);
    seen.bend_to.w = end.log_value = log_value(end);
    float shade = delivered.shade[s.cell];
    seen.half_width = float[2](half_width(begin, shade), half_width(end, shade));
    if (solid) {
        seen.half_width = float[2](seen.half_width[0] * s.alpha, seen.half_width[1] * s.alpha);
        seen.alpha /= s.alpha;
    }
    set_bends(s, span, before, after, seen);
    set_places(s, span, seen);
    seen.flags = (bent ? BENT : 0u) | (s.before == s.from ? FREE_BEGIN : 0u) | (s.after == s.to ? FREE_END : 0u);
    seen.batch = uint(batch_of(seen.strokes) + (bent ? SIZES : 0));
    return true;
}

void main() {
    uint slot = gl_GlobalInvocationID.x, thread = gl_LocalInvocationIndex;
    if (thread < BATCHES) in_batch[thread] = 0u;
    barrier();
    if (slot < segment_count) {
        Seen seen;
        bool any_ = look(segments.segment[slot], seen);
        seen_segments.seen[slot] = seen;
        if (any_) atomicAdd(in_batch[seen.batch], 1u);
    }
    barrier();
    if (thread < BATCHES) counts.count[gl_WorkGroupID.x * BATCHES + thread] = in_batch[thread];
}
