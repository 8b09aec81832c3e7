#version 450 core
// One triangle that covers the viewport, at a depth: a pass over the pixels that are marked with it.

uniform float depth; // of the buffer, 0 to 1

void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, depth, 1.0);
}
