#version 450 core
// What this view sees of each segment: whether anything, at which level of detail, and how wide its strokes are.
#include "shade_strokes/batches.glsl"
#include "shade_strokes/bend.glsl"

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
uniform float world_scale; // metres that one of the mesh's units is in the world
uniform float front;       // -1 where the transform mirrors, else 1
uniform bool solid;        // strokes get thinner, not fainter

const float BEND_PIXELS = 0.25; // that make strokes bend
const float LEAST_SIDE = 0.02;  // of a patch, over the largest, that says which way it looks

shared uint in_batch[BATCHES];

// Length at rest, in the mesh's units. Between chains that were joined counts do not agree, and the straight line does.
float rest_length(uint a, uint b) {
    float chord = distance(middle(a), middle(b)) / world_scale;
    float along = nodes.node[b].along - nodes.node[a].along;
    bool counted = nodes.node[a].random == nodes.node[b].random && along > 0.25 * chord && along < 4.0 * chord;
    return max(counted ? along : chord, 1e-9);
}

// Whether the surface looks towards the eye, or edge on, anywhere: 1, and 0 where all of it looks away. Where a patch
// is folded to nothing its normals are noise.
float facing(uint from, uint to) {
    vec3 along = middle(to) - middle(from);
    float size[2 * RIB_POINTS], sine[2 * RIB_POINTS], largest = 0.0;
    for (int i = 0; i < 2 * RIB_POINTS; ++i) {
        size[i] = 0.0;
        uint point = (i < RIB_POINTS ? from : to) * RIB_POINTS + i % RIB_POINTS;
        if (i % RIB_POINTS == RIB_POINTS - 1) continue;
        vec3 right = ribs.at[point].xyz;
        vec3 normal = cross(along, ribs.at[point + 1u].xyz - right);
        size[i] = length(normal);
        sine[i] = front * dot(normal, towards_eye(right)) / max(size[i], 1e-30);
        largest = max(largest, size[i]);
    }
    float most = 0.0;
    for (int i = 0; i < 2 * RIB_POINTS; ++i)
        if (size[i] > 0.0)
            most = max(most, smoothstep(-0.1, 0.0, sine[i]) * min(1.0, size[i] / (LEAST_SIDE * largest)));
    return most;
}

// Whether a patch is outside the picture.
bool outside(uint from, uint to, float margin) {
    vec2 low = vec2(1e30), high = vec2(-1e30);
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < RIB_POINTS; ++k) {
            vec2 at;
            project(ribs.at[(i == 0 ? from : to) * RIB_POINTS + k].xyz, at);
            low = min(low, at);
            high = max(high, at);
        }
    return any(lessThan(high, vec2(-margin))) || any(greaterThan(low, viewport + margin));
}

// Whether a rib bends so much that straight strokes would leave it by more than a part of a pixel.
bool bends(uint node) {
    vec3 right = ribs.at[node * RIB_POINTS].xyz, left = ribs.at[node * RIB_POINTS + 4u].xyz;
    float most = BEND_PIXELS * pixel_size * (clip_from_world * vec4(middle(node), 1.0)).w;
    for (int k = 1; k + 1 < RIB_POINTS; ++k) {
        vec4 point = ribs.at[node * RIB_POINTS + k];
        if (distance(point.xyz, mix(right, left, 0.5 + 0.5 * point.w)) > most) return true;
    }
    return false;
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
    seen.level = level_of(min(seen.log_value[0], seen.log_value[1]), t);
    int begin = point_before(seen.set[0], seen.place[0]);
    int end = point_before(seen.set[0], seen.place[0] + seen.span);
    while ((end >> seen.level) - (begin >> seen.level) >= MOST_STROKES) ++seen.level;
    seen.first = ((begin >> seen.level) + 1) << seen.level;
    seen.strokes = (end >> seen.level) - (begin >> seen.level) + 1;
}

// How much a segment's chain ends where another one is beside it, or NONE: one that fades out leaves an end, and one
// that comes takes it away, without a jump.
float free_of(Segment s, uint beside) {
    if (beside == NONE) return 1.0;
    return clamp(1.0 - 2.0 * segments.segment[beside].alpha / max(s.alpha, 1e-6), 0.0, 1.0);
}

// False where nothing of it can be seen.
bool look(Segment s, out Seen seen) {
    seen = Seen(vec2(0.0), vec2(0.0), float[2](0.0, 0.0), float[2](0.0, 0.0), float[2](0.0, 0.0), 0.0, 0.0,
                float[2](free_of(s, s.before), free_of(s, s.after)), uint[2](0u, 0u), uint[2](s.from, s.to), 0, 0, 0,
                0u, 0u);
    if (s.cell == NONE || !(s.alpha > 0.0)) return false;
    seen.alpha = facing(s.from, s.to) * s.alpha;
    if (!(seen.alpha > 0.0) || outside(s.from, s.to, MOST_WIDTH * line_width + 1.0)) return false;

    float span = rest_length(s.from, s.to);
    uint beside[2] = uint[2](s.before != NONE ? segments.segment[s.before].from : s.from,
                             s.after != NONE ? segments.segment[s.after].to : s.to);
    float before = s.before != NONE ? rest_length(beside[0], s.from) : 0.0;
    float after = s.after != NONE ? rest_length(s.to, beside[1]) : 0.0;
    Lie begin, end;
    vec2 alone;
    bool ok = along_of(s.from, s.to, span, alone);
    ok = lie_at(beside[0], s.from, s.to, before + span, begin) && ok;
    ok = lie_at(s.from, s.to, beside[1], span + after, end) && ok;
    if (!ok) return false;
    begin.along = mix(begin.along, alone, seen.free[0]);
    end.along = mix(end.along, alone, seen.free[1]);
    seen.log_value[0] = begin.log_value = log_value(begin);
    seen.log_value[1] = end.log_value = log_value(end);
    float shade = delivered.shade[s.cell];
    seen.half_width = float[2](half_width(begin, shade), half_width(end, shade));
    if (solid) {
        seen.half_width = float[2](seen.half_width[0] * s.alpha, seen.half_width[1] * s.alpha);
        seen.alpha /= s.alpha;
    }
    set_bends(s, beside, span, before, after, seen);
    set_places(s, span, seen);
    bool bent = bends(s.from) || bends(s.to);
    seen.flags = bent ? BENT : 0u;
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
