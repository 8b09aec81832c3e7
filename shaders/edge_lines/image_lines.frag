#version 450 core
// Lines around the marks of image_marks.frag: as wide as they are asked to be, with a smooth rim.
#include "common/view.glsl"
#include "edge_lines/image_styles.glsl"

layout(binding = 0) uniform usampler2D marks;
layout(binding = 1) uniform sampler2D depth_buffer;

uniform int reach; // pixels from which a line can come

layout(location = 0) out vec4 out_line;

float half_width(uint object, ivec2 pixel, ivec2 side) {
    float wide = styles[object].line.w;
    if (wide >= 0.0) return wide;
    float nearer = max(texelFetch(depth_buffer, pixel, 0).r, texelFetch(depth_buffer, pixel + side, 0).r);
    return -wide / (eye.w > 0.0 ? view_depth(nearer) : 1.0);
}

// A mark is a piece of the line half a pixel long, between the two pixels: slanted lines are stairs of such marks, whose
// middles lie along the line.
void lay(uint mark, vec2 offset, ivec2 pixel, ivec2 side, inout vec4 line) {
    if (mark == 0u) return;
    vec2 along = vec2(side.y, side.x);
    float away = length(offset - clamp(dot(offset, along), -0.25, 0.25) * along);
    float wide = half_width(mark / 2u, pixel, side);
    float coverage = clamp(wide - away + 0.5, 0.0, min(1.0, 2.0 * wide));
    if (coverage <= line.a) return;
    vec3 color = (mark & 1u) != 0u ? styles[mark / 2u].crease.rgb : styles[mark / 2u].line.rgb;
    line = vec4(color * coverage, coverage);
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = ivec2(viewport) - 1;
    out_line = vec4(0.0);
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            ivec2 pixel = here + ivec2(x, y);
            if (any(lessThan(pixel, ivec2(0))) || any(greaterThan(pixel, last))) continue;
            uvec2 found = texelFetch(marks, pixel, 0).rg;
            lay(found.x, vec2(x, y) + vec2(0.5, 0.0), pixel, ivec2(1, 0), out_line);
            lay(found.y, vec2(x, y) + vec2(0.0, 0.5), pixel, ivec2(0, 1), out_line);
        }
    if (out_line.a <= 0.0) discard;
}
