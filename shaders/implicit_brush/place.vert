#version 450 core
// Where a vertex is, and where it was on the surface at rest; systems/implicit_brush/surface_places.h sets it up.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position; // entity space
#ifdef DEFORMED
layout(binding = 1) uniform sampler2D rest_positions; // by vertex, row after row (runtime/scene/vertex_textures.h)
#endif

uniform mat4 world_from_entity;
uniform vec3 rest_middle;
uniform float rest_radius;

out vec3 place;

void main() {
    // As in surface.vert, so that depths agree.
    vec4 world = world_from_entity * vec4(in_position, 1.0);
    gl_Position = clip_from_world * world;
#ifdef DEFORMED
    int columns = textureSize(rest_positions, 0).x;
    vec3 rest = texelFetch(rest_positions, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).xyz;
#else
    vec3 rest = in_position;
#endif
    place = (rest - rest_middle) / rest_radius;
}
