#version 450 core
// Lines around the marks of image_marks.frag: as wide as they are asked to be, with a smooth rim.
#include "edge_lines/image_styles.glsl"

layout(binding = 0) uniform sampler2D half_widths;
layout(binding = 1) uniform usampler2D marks;

uniform ivec4 area; // first and last pixel that can have a mark
uniform int reach;  // pixels from which a line can come

layout(location = 0) out vec4 out_line;

// A mark is a piece of the line half a pixel long, between the two pixels: slanted lines are stairs of such marks, whose
// middles lie along the line.
float cover(float wide, vec2 offset, vec2 along) {
    float away = length(offset - clamp(dot(offset, along), -0.25, 0.25) * along);
    return clamp(wide - away + 0.5, 0.0, min(1.0, 2.0 * wide));
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), from = here;
    float coverage = 0.0;
    bool above = false;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            ivec2 pixel = here + ivec2(x, y);
            vec2 wide = texelFetch(half_widths, clamp(pixel, area.xy, area.zw), 0).rg;
            if (any(lessThan(pixel, area.xy)) || any(greaterThan(pixel, area.zw))) wide = vec2(0.0);
            float right = cover(wide.x, vec2(x, y) + vec2(0.5, 0.0), vec2(0.0, 1.0));
            float up = cover(wide.y, vec2(x, y) + vec2(0.0, 0.5), vec2(1.0, 0.0));
            if (max(right, up) <= coverage) continue;
            coverage = max(right, up);
            above = up > right;
            from = pixel;
        }
    out_line = vec4(0.0);
    if (coverage <= 0.0) return;
    uvec2 found = texelFetch(marks, from, 0).rg;
    uint mark = above ? found.y : found.x;
    vec3 color = (mark & 1u) != 0u ? styles[mark / 2u].crease.rgb : styles[mark / 2u].line.rgb;
    out_line = vec4(color * coverage, coverage);
}
