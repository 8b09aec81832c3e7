#version 450 core
// Writes the list of segments that are seen, batch after batch, in the order of slots.
#include "shade_strokes/batches.glsl"
#include "shade_strokes/data.glsl"

layout(local_size_x = GROUP) in;

layout(std430, binding = 5) readonly buffer SeenSegments { Seen seen[]; }
segments;
layout(std430, binding = 6) readonly buffer Counts { uint place[]; } // by group and batch
places;
layout(std430, binding = 7) writeonly buffer List { uint slot[]; }
list;

uniform uint segment_count;

shared uint batches[GROUP];

void main() {
    uint slot = gl_GlobalInvocationID.x, thread = gl_LocalInvocationIndex;
    bool seen = slot < segment_count && segments.seen[slot].strokes > 0;
    uint batch = seen ? segments.seen[slot].batch : NONE;
    batches[thread] = batch;
    barrier();
    if (!seen) return;
    uint place = places.place[gl_WorkGroupID.x * BATCHES + batch];
    for (uint i = 0u; i < thread; ++i) place += uint(batches[i] == batch);
    list.slot[place] = slot;
}
