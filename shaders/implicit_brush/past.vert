#version 450 core
// Where a vertex is, and where it was when the noise of each phase was made; systems/implicit_brush/noise_phases.h
// sets it up.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position; // entity space
#ifdef DEFORMED
// By vertex, row after row (runtime/scene/vertex_textures.h).
layout(binding = 1) uniform sampler2D past_positions_0;
layout(binding = 2) uniform sampler2D past_positions_1;

vec3 by_vertex(sampler2D positions) {
    int columns = textureSize(positions, 0).x;
    return texelFetch(positions, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).xyz;
}
#endif

uniform mat4 world_from_entity;
uniform mat4 past_clip_from_entity[2];

out vec4 past_clip_0;
out vec4 past_clip_1;

void main() {
    // As in surface.vert, so that depths agree.
    vec4 world = world_from_entity * vec4(in_position, 1.0);
    gl_Position = clip_from_world * world;
#ifdef DEFORMED
    past_clip_0 = past_clip_from_entity[0] * vec4(by_vertex(past_positions_0), 1.0);
    past_clip_1 = past_clip_from_entity[1] * vec4(by_vertex(past_positions_1), 1.0);
#else
    past_clip_0 = past_clip_from_entity[0] * vec4(in_position, 1.0);
    past_clip_1 = past_clip_from_entity[1] * vec4(in_position, 1.0);
#endif
}
