#version 450 core
// Writes where disks begin and end along rows: running sums of that (running_sums.comp) are the sums of the disks. So a
// disk costs its rim, not its area. Numbers are whole, so that neither order nor length of a row changes a sum.
// Define: GROUP.
#include "implicit_brush/stamp.glsl"
#include "implicit_brush/plan.glsl"

layout(local_size_x = GROUP) in;
layout(binding = 3) uniform usampler2D stamp_list; // x in the lower half, y in the upper one
layout(r32ui, binding = 0) uniform uimage2D sums;  // channels of a pixel beside each other

uniform ivec4 painted; // first x, y, last x, y of the pixels that get ink
uniform float fixed_point;

#ifdef SAME_COLOR
#define CHANNELS 1
#define WHOLE int
#else
#define CHANNELS 4
#define WHOLE ivec4
#endif

void add(int x, int y, WHOLE change) {
#ifdef SAME_COLOR
    if (change != 0) imageAtomicAdd(sums, ivec2(x, y), uint(change));
#else
    for (int c = 0; c < 4; ++c)
        if (change[c] != 0) imageAtomicAdd(sums, ivec2(4 * x + c, y), uint(change[c]));
#endif
}

// Half the width of a disk of that squared radius at a height; less than 0 where it is none.
float half_chord(float radius2, float height) {
    float left = radius2 - height * height;
    return left > 0.0 ? sqrt(left) : -1.0;
}

// Pixels `from` to `to` of a row, counted from the stamp's pixel; `before` is what the pixel left of them has. Returns
// what the last one has.
WHOLE add_rim(int from, int to, int row, ivec2 pixel, Stamp stamp, WHOLE before) {
    for (int x = max(from, painted.x - pixel.x); x <= min(to, painted.z - pixel.x); ++x) {
        WHOLE here = WHOLE(round(stamp.ink * round_disk(vec2(x, row) - stamp.shift, stamp.radius)));
        add(pixel.x + x, pixel.y + row, here - before);
        before = here;
    }
    return before;
}

void add_row(int row, ivec2 pixel, Stamp stamp) {
    // round_disk() looks at places a quarter pixel around; it is constant up to `inner` and nothing from `outer` on.
    float drawn = max(stamp.radius, 1.0), height = abs(float(row) - stamp.shift.y);
    float outer = half_chord(drawn * drawn + drawn, max(height - 0.25, 0.0)) + 0.25;
    float inner = half_chord(drawn * drawn - drawn, height + 0.25) - 0.25;
    int left = int(ceil(stamp.shift.x - outer)), right = int(floor(stamp.shift.x + outer));
    WHOLE before = WHOLE(0);
    if (inner > 1.0) {
        // The constant part begins at its left end, or where the picture does.
        int from = int(ceil(stamp.shift.x - inner)), to = int(floor(stamp.shift.x + inner));
        before = add_rim(left, min(max(from, painted.x - pixel.x), to), row, pixel, stamp, before);
        left = to;
    }
    before = add_rim(left, right, row, pixel, stamp, before);
    int end = pixel.x + right + 1;
    if (end >= painted.x && end <= painted.z) add(end, pixel.y + row, -before);
}

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= int(plan.stamp_count)) return;
    int columns = textureSize(stamp_list, 0).x;
    uint packed_ = texelFetch(stamp_list, ivec2(index % columns, index / columns), 0).r;
    ivec2 pixel = ivec2(packed_ & 0xffffu, packed_ >> 16);
    vec4 weighted = texelFetch(stamp_inks, pixel, 0);
    Stamp stamp = make_stamp(place_of(pixel), vec4(clamp(weighted.rgb, -16.0, 16.0), weighted.a));
    stamp.ink *= fixed_point;
    float far = max(stamp.radius, 1.0) + 1.0;
    int low = max(int(ceil(stamp.shift.y - far)), painted.y - pixel.y);
    int high = min(int(floor(stamp.shift.y + far)), painted.w - pixel.y);
    for (int row = low; row <= high; ++row) add_row(row, pixel, stamp);
}
