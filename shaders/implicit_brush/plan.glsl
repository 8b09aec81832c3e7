// What is drawn, as the GPU decided: systems/implicit_brush/convolution_plan.h has the same on the CPU.

struct DrawCommand {
    uint vertices, instances, first_vertex, first_instance;
};

layout(std430, binding = 0) buffer Plan {
    DrawCommand splats;      // of the stamps in the list
    DrawCommand splat_tiles; // those that they reach
    DrawCommand gather_tiles;
    DrawCommand marked_tiles;
    DrawCommand sum_tiles;
    DrawCommand sum_clear; // one triangle over all
    uvec3 list_groups;
    uint method; // 1 splat, 2 gather, 3 tiles, 4 sums
    uvec3 edge_groups;
    uint stamp_count;
    uvec3 sum_groups;
    uint tile_count;
    uint pair_count; // of a tile and a stamp near it
}
plan;
