// What is drawn, as the GPU decided: systems/implicit_brush/convolution_plan.h has the same on the CPU.

struct DrawCommand {
    uint vertices, instances, first_vertex, first_instance;
};

layout(std430, binding = 0) buffer Plan {
    DrawCommand splats;      // of the stamps in the list
    DrawCommand splat_tiles; // those that they reach
    DrawCommand gather_tiles;
    DrawCommand marked_tiles;
    uvec3 list_groups;
    uint method; // 1 splat, 2 gather, 3 tiles
    uint stamp_count;
    uint tile_count;
    uint pair_count; // of a tile and a stamp near it
}
plan;
