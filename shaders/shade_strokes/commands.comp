#version 450 core
// From how many segments of each batch there are in each group: where each group's part of the list is, and the
// commands that draw the batches. One work group. Sums in whole numbers, in the order of slots: the same ones always.
#include "shade_strokes/batches.glsl"

layout(local_size_x = 64) in;

struct DrawCommand {
    uint indices, instances, first_index;
    int base_vertex;
    uint first_instance;
};
layout(std430, binding = 6) buffer Counts { uint count[]; } // by group and batch: in counts, out places
counts;
layout(std430, binding = 7) writeonly buffer Commands { DrawCommand command[BATCHES]; }
commands;

uniform uint group_count;

shared uint total[BATCHES];

void main() {
    uint batch = gl_LocalInvocationIndex;
    if (batch < BATCHES) {
        uint sum = 0u;
        for (uint g = 0u; g < group_count; ++g) sum += counts.count[g * BATCHES + batch];
        total[batch] = sum;
    }
    barrier();
    if (batch >= BATCHES) return;
    uint start = 0u;
    for (uint b = 0u; b < batch; ++b) start += total[b];
    int size = batch_size(int(batch) % SIZES);
    bool bent = batch >= SIZES;
    commands.command[batch] =
        DrawCommand(uint(size) * (bent ? 24u : 6u), total[batch], 0u, 0, start);
    for (uint g = 0u; g < group_count; ++g) {
        uint mine = counts.count[g * BATCHES + batch];
        counts.count[g * BATCHES + batch] = start;
        start += mine;
    }
}
