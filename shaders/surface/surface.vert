#version 450 core
// Vertex stage of everything that is drawn from a mesh; runtime/scene/surface_renderer.h sets it up.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec2 in_texcoord;
layout(location = 3) in vec4 in_color;

uniform mat4 world_from_entity;
uniform mat3 world_from_normal;
#ifdef BASE_COLOR_TEXTURE
uniform vec3 texcoord_u; // rows of the affine map of (u, v, 1)
uniform vec3 texcoord_v;
out vec2 texcoord;
#endif
#ifdef VERTEX_COLOR
out vec4 vertex_color;
#endif
out vec3 world_position;
out vec3 world_normal;

void main() {
    vec4 world = world_from_entity * vec4(in_position, 1.0);
    world_position = world.xyz;
    world_normal = world_from_normal * in_normal;
#ifdef BASE_COLOR_TEXTURE
    vec3 uv = vec3(in_texcoord, 1.0);
    texcoord = vec2(dot(texcoord_u, uv), dot(texcoord_v, uv));
#endif
#ifdef VERTEX_COLOR
    vertex_color = in_color;
#endif
    gl_Position = clip_from_world * world;
}
