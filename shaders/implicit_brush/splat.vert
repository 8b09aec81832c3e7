#version 450 core
// A box around each stamp: two triangles per pixel that stamps.
// Define: EVERY_PIXEL to draw one per pixel of the picture, as the paper does; else those of a list.
#include "implicit_brush/stamp.glsl"

layout(binding = 3) uniform usampler2D stamp_list; // x in the lower half, y in the upper one

uniform vec2 picture; // px

flat out ivec2 stamp_pixel;
flat out vec2 stamp_shift;
flat out float stamp_radius;
flat out vec2 stamp_turn;
flat out SUM stamp_ink;

ivec2 pixel_of(int index) {
#ifdef EVERY_PIXEL
    int columns = textureSize(stamp_inks, 0).x;
    return ivec2(index % columns, index / columns);
#else
    int columns = textureSize(stamp_list, 0).x;
    uint packed_ = texelFetch(stamp_list, ivec2(index % columns, index / columns), 0).r;
    return ivec2(packed_ & 0xffffu, packed_ >> 16);
#endif
}

void main() {
    int corner = gl_VertexID % 6;
    stamp_pixel = pixel_of(gl_VertexID / 6);
    Stamp stamp = make_stamp(place_of(stamp_pixel), texelFetch(stamp_inks, stamp_pixel, 0));
    stamp_shift = stamp.shift;
    stamp_radius = stamp.radius;
    stamp_turn = stamp.turn;
    stamp_ink = stamp.ink;
    vec2 side = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    vec2 box = (2.0 * side - 1.0) * (footprint_box(stamp.radius) + 0.01);
    vec2 place = vec2(stamp_pixel) + 0.5 + stamp.shift + box.x * stamp.turn +
                 box.y * vec2(-stamp.turn.y, stamp.turn.x);
    gl_Position = vec4(place / picture * 2.0 - 1.0, 0.0, 1.0);
}
