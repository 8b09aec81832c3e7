#version 450 core
// One instance per piece of a stroke: a box around it on the screen, wide enough for its round ends and their smooth
// rim. systems/abstracted_lines/stroke_batches.h says what the inputs are.
#include "common/view.glsl"

layout(location = 0) in vec4 in_segment;
layout(location = 1) in vec2 in_half_width;
layout(location = 2) in vec2 in_opacity;
layout(location = 3) in vec2 in_arc;
layout(location = 4) in vec2 in_ends;
layout(location = 5) in vec3 in_ahead;
layout(location = 6) in vec3 in_weights;
layout(location = 7) in vec2 in_turn;

flat out vec4 segment;
flat out vec2 half_widths;
flat out vec2 opacities;
flat out vec2 arcs;
flat out vec2 ends;
flat out vec3 ahead;
flat out vec3 weights;
flat out vec2 turn;

void main() {
    segment = in_segment;
    half_widths = in_half_width;
    opacities = in_opacity;
    arcs = in_arc;
    ends = in_ends;
    ahead = in_ahead;
    weights = in_weights;
    turn = in_turn;

    vec2 p = in_segment.xy;
    vec2 q = in_segment.zw;
    vec2 along = q - p;
    float length_ = length(along);
    along = length_ > 1e-6 ? along / length_ : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float reach = max(half_widths.x, half_widths.y) + 1.0;
    bool at_end = (gl_VertexID & 1) != 0;
    float side = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
    vec2 corner = (at_end ? q + along * reach : p - along * reach) + side * reach * across;
    gl_Position = vec4(corner / viewport * 2.0 - 1.0, 0.0, 1.0);
}
