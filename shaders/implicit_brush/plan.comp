#version 450 core
// Counts stamps and the tiles that they reach, lists those tiles, says where each texel's stamps go in the list of
// stamps, and chooses how to add them up. One work group: a few ten thousand texels at most.
#include "implicit_brush/plan.glsl"

layout(local_size_x = GROUP) in;

layout(binding = 2) uniform usampler2D marks;
layout(binding = 3) uniform usampler2D reached;
layout(r32ui, binding = 0) uniform writeonly uimage2D starts; // of marks' texels in the list
layout(r32ui, binding = 1) uniform writeonly uimage2D tiles;

uniform ivec4 mark_area; // x, y, width, height of what was marked, texels
uniform int sum_rows;    // of running sums
uniform int forced;      // a method, or 0 for the cheapest

// Nanoseconds (systems/implicit_brush/convolution_cost.h).
uniform float splat_stamp, splat_tile;
uniform float gather_tile, gather_pair;
uniform float marked_tile, marked_pair;
uniform float sum_all, sum_stamp, sum_tile; // less than 0 where there are no such sums

shared uint sums[GROUP];

// What the threads before this one have; `total` is that of all.
uint before(uint mine, out uint total) {
    uint thread = gl_LocalInvocationIndex;
    barrier();
    sums[thread] = mine;
    barrier();
    for (uint step_ = 1u; step_ < uint(GROUP); step_ *= 2u) {
        uint left = thread >= step_ ? sums[thread - step_] : 0u;
        barrier();
        sums[thread] += left;
        barrier();
    }
    total = sums[GROUP - 1];
    return sums[thread] - mine;
}

// The part of `count` things that a thread looks after.
void share(int count, out int from, out int to) {
    int each = (count + GROUP - 1) / GROUP;
    from = min(int(gl_LocalInvocationIndex) * each, count);
    to = min(from + each, count);
}

ivec2 mark_texel(int index) { return mark_area.xy + ivec2(index % mark_area.z, index / mark_area.z); }

uint count_stamps() {
    int from, to;
    share(mark_area.z * mark_area.w, from, to);
    uint stamps = 0u, total;
    for (int i = from; i < to; ++i) stamps += uint(bitCount(texelFetch(marks, mark_texel(i), 0).r));
    uint start = before(stamps, total);
    for (int i = from; i < to; ++i) {
        imageStore(starts, mark_texel(i), uvec4(start));
        start += uint(bitCount(texelFetch(marks, mark_texel(i), 0).r));
    }
    return total;
}

uint list_tiles(out uint pairs) {
    ivec2 size = textureSize(reached, 0);
    int from, to;
    share(size.x * size.y, from, to);
    uint count = 0u, near = 0u, total;
    for (int i = from; i < to; ++i) {
        uint stamps = texelFetch(reached, ivec2(i % size.x, i / size.x), 0).r;
        near += stamps;
        count += uint(stamps > 0u);
    }
    int place = int(before(count, total));
    for (int i = from; i < to; ++i) {
        ivec2 tile = ivec2(i % size.x, i / size.x);
        if (texelFetch(reached, tile, 0).r == 0u) continue;
        imageStore(tiles, ivec2(place % size.x, place / size.x), uvec4(tile.x | tile.y << 16));
        ++place;
    }
    before(near, pairs);
    return total;
}

uint cheapest(uint stamps, uint reached_tiles, uint pairs) {
    float splat = float(stamps) * splat_stamp + float(reached_tiles) * splat_tile;
    float gather = float(reached_tiles) * gather_tile + float(pairs) * gather_pair;
    float marked = float(reached_tiles) * marked_tile + float(pairs) * marked_pair;
    float sums = sum_all + float(stamps) * sum_stamp + float(reached_tiles) * sum_tile;
    float least = min(splat, min(gather, marked));
    if (sum_all >= 0.0 && sums < least) return 4u;
    return splat == least ? 1u : gather == least ? 2u : 3u;
}

uvec3 groups(int items, int of_group) { return uvec3((items + of_group - 1) / of_group, 1, 1); }

DrawCommand triangles(uint pairs, bool chosen) { return DrawCommand(chosen ? 6u * pairs : 0u, 1u, 0u, 0u); }

void main() {
    uint stamps = count_stamps(), pairs;
    uint reached_tiles = list_tiles(pairs);
    if (gl_LocalInvocationIndex > 0u) return;
    uint method = forced > 0 ? uint(forced) : cheapest(stamps, reached_tiles, pairs);
    plan.splats = triangles(stamps, method == 1u);
    plan.splat_tiles = triangles(reached_tiles, method == 1u);
    plan.gather_tiles = triangles(reached_tiles, method == 2u);
    plan.marked_tiles = triangles(reached_tiles, method == 3u);
    plan.sum_tiles = triangles(reached_tiles, method == 4u);
    plan.sum_clear = DrawCommand(method == 4u ? 3u : 0u, 1u, 0u, 0u);
    bool listed = (method == 1u || method == 4u) && stamps > 0u;
    plan.list_groups = groups(listed ? mark_area.z * mark_area.w : 0, LIST_GROUP);
    plan.edge_groups = groups(method == 4u ? int(stamps) : 0, SUM_GROUP);
    plan.sum_groups = groups(method == 4u && stamps > 0u ? sum_rows : 0, SUM_GROUP);
    plan.method = method;
    plan.stamp_count = stamps;
    plan.tile_count = reached_tiles;
    plan.pair_count = pairs;
}
