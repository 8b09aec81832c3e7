#version 450 core
// Where a vertex is, and where it was in the frame before.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position; // entity space
#ifdef DEFORMED
layout(location = 1) in vec3 in_previous;
#endif

uniform mat4 world_from_entity;
uniform mat4 previous_clip_from_entity;

out vec4 now;
out vec4 before;

void main() {
    // As in surface.vert, so that depths agree.
    vec4 world = world_from_entity * vec4(in_position, 1.0);
    now = clip_from_world * world;
#ifdef DEFORMED
    before = previous_clip_from_entity * vec4(in_previous, 1.0);
#else
    before = previous_clip_from_entity * vec4(in_position, 1.0);
#endif
    gl_Position = now;
}
