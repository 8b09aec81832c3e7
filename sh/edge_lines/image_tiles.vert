#version 450 core
// A point as large as a tile for each tile that image_tiles.frag marked, none for the others.

const int TILE = 8; // as in image_breaks.glsl

layout(binding = 3) uniform sampler2D tiles;

uniform ivec2 grid; // tiles along each axis of the viewport
uniform int margin; // pixels around the tile that are drawn, too

void main() {
    ivec2 tile = ivec2(gl_VertexID % grid.x, gl_VertexID / grid.x);
    vec2 middle = (vec2(tile) + 0.5) / vec2(grid) * 2.0 - 1.0;
    bool marked = texelFetch(tiles, tile, 0).r > 0.5;
    gl_Position = vec4(marked ? middle : vec2(2.0), 0.0, 1.0);
    gl_PointSize = float(TILE + 2 * margin);
}
