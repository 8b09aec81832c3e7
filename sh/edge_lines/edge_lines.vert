#version 450 core
// One instance per piece of a line: a box around it on the screen, wide enough for the line, its round ends and their
// smooth rim. systems/edge_lines/line_set.h says what the inputs are.
#include "common/view.glsl"

layout(location = 0) in vec4 in_segment;
layout(location = 1) in vec2 in_depth;
layout(location = 2) in vec2 in_half_width;
layout(location = 3) in vec2 in_weight;
layout(location = 4) in vec2 in_arc;
layout(location = 5) in vec2 in_ends;

uniform float width_factor;

flat out vec4 segment;
flat out vec2 depths;
flat out vec2 half_widths;
flat out vec2 weights;
flat out vec2 arcs;
flat out vec2 ends;

void main() {
    segment = in_segment;
    depths = in_depth;
    half_widths = in_half_width * width_factor;
    weights = in_weight;
    arcs = in_arc;
    ends = in_ends;

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
