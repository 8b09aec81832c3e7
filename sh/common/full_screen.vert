#version 450 core
// One triangle that covers the viewport, made of the vertex number alone: (-1,-1), (3,-1), (-1,3).

layout(location = 0) out vec2 uv; // 0..1 over the viewport, (0,0) at its lower left corner

void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    uv = corner;
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
