// What strokes of a surface are drawn from; systems/shade_strokes/shade_buffers.h has the same on the CPU.

const uint NONE = 0xffffffffu; // no slot
const int RIB_POINTS = 5;
const int TABLE_POINTS = 256; // of a zigzag

// As shade_chains.h has them.
struct Node {
    uint rib[3 * RIB_POINTS]; // by point: triangle, and the bits of the weights of its corners 1 and 2
    float bend[2];
    float amplitude;
    float along;
    uint random;
};
struct Segment {
    uint from, to;      // nodes
    uint before, after; // segments
    uint cell, chain;
    float alpha;
    uint random;
};

// A segment as this view sees it (segments.comp).
struct Seen {
    vec2 bend_from; // how far the first inner point of its curve leaves the straight line: along it, over its length;
    vec2 bend_to;   // and across it, over the amplitude. The second inner point
    float log_value[2];  // log2 of the level of detail's value at its begin and its end
    float half_width[2]; // of its strokes, pixels: begin, end
    float place[2];      // in the zigzag where it begins: counted on from its begin, and back from its end
    float span;          // of the zigzag
    float alpha;
    float free[2]; // how much the chain ends at its begin, at its end: 1 alone, 0 where it goes on as strongly
    uint set[2]; // the zigzag, as counted from its begin and from its end: others where two chains were joined
    uint nodes[2];
    int first;   // the first point of the zigzag within it
    int strokes; // how many; 0 where it isn't seen
    int level;   // log2 of the distance of points
    uint flags;
    uint batch;
};
const uint BENT = 1u; // its strokes bend with the surface
