#version 450 core
// Two triangles over each tile that stamps reach.
// Define: TILE.

layout(binding = 4) uniform usampler2D tiles; // x in the lower half, y in the upper one

uniform vec2 picture; // px

void main() {
    int index = gl_VertexID / 6, corner = gl_VertexID % 6;
    int columns = textureSize(tiles, 0).x;
    uint tile = texelFetch(tiles, ivec2(index % columns, index / columns), 0).r;
    vec2 side = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    vec2 place = float(TILE) * (vec2(tile & 0xffffu, tile >> 16) + side);
    gl_Position = vec4(place / picture * 2.0 - 1.0, 0.0, 1.0);
}
