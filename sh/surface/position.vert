#version 450 core
// Positions alone: the floor that frame times are compared with.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position;
uniform mat4 world_from_entity;

void main() { gl_Position = clip_from_world * (world_from_entity * vec4(in_position, 1.0)); }
