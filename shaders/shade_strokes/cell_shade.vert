#version 450 core
// Triangles one by one, three vertices each, so that fragments know where in which triangle they are.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position; // entity space
uniform mat4 world_from_entity;

out vec3 weight; // of the triangle's corners
flat out uint triangle;

void main() {
    int corner = gl_VertexID % 3;
    weight = vec3(equal(ivec3(corner), ivec3(0, 1, 2)));
    triangle = uint(gl_VertexID / 3);
    // As in surface.vert, so that depths agree.
    gl_Position = clip_from_world * (world_from_entity * vec4(in_position, 1.0));
}
