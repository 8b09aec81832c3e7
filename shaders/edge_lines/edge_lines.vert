#version 450 core
// One instance per segment: a screen-space box around it, wide enough for the line, its round ends and their smooth rim.
#include "common/view.glsl"

layout(location = 0) in vec3 in_start; // entity space
layout(location = 1) in vec3 in_end;

uniform mat4 world_from_entity;
uniform float half_width; // pixels

flat out vec4 segment; // start and end, pixels
flat out vec2 depths;  // window depth at start and end

// Cuts the end `inside`-`outside` at the near plane, where the clip w of what is drawn stays positive.
vec4 clip_near(vec4 inside, vec4 outside) {
    float a = inside.w - inside.z; // reversed depth: visible where z <= w
    float b = outside.w - outside.z;
    return b < 0.0 ? mix(inside, outside, a / (a - b)) : outside;
}

void main() {
    mat4 clip_from_entity = clip_from_world * world_from_entity;
    vec4 a = clip_from_entity * vec4(in_start, 1.0);
    vec4 b = clip_from_entity * vec4(in_end, 1.0);
    if (a.z > a.w && b.z > b.w) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec4 near_a = clip_near(b, a);
    b = clip_near(a, b);
    a = near_a;

    vec2 p = (a.xy / a.w * 0.5 + 0.5) * viewport;
    vec2 q = (b.xy / b.w * 0.5 + 0.5) * viewport;
    segment = vec4(p, q);
    depths = vec2(a.z / a.w, b.z / b.w);

    vec2 along = q - p;
    float length_ = length(along);
    along = length_ > 1e-6 ? along / length_ : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float reach = half_width + 1.0;
    bool at_end = (gl_VertexID & 1) != 0;
    float side = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
    vec2 corner = (at_end ? q + along * reach : p - along * reach) + side * reach * across;
    gl_Position = vec4(corner / viewport * 2.0 - 1.0, 0.0, 1.0);
}
