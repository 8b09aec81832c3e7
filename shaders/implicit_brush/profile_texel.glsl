// Feature data at and between pixels.
#include "implicit_brush/direction.glsl"

layout(binding = 0) uniform sampler2D features; // h, cos and sin of twice theta's angle, gamma

uniform ivec4 area; // first and last pixel that have features

// h and gamma at an offset from the pixel's centre, px: between the four texels around, by whole texels and a fraction
// that do not depend on where in the picture the pixel is, so that what moves by whole pixels keeps its lines bit for
// bit, which a filter of the driver does not promise.
struct Between {
    vec2 corner; // the texels' common corner, as gathers take it
    vec2 part;
};

Between between(vec2 offset) {
    vec2 pixel = floor(gl_FragCoord.xy);
    offset = clamp(pixel + offset, vec2(area.xy), vec2(area.zw)) - pixel;
    vec2 whole = floor(offset);
    return Between((pixel + whole + 1.0) / vec2(textureSize(features, 0)), offset - whole);
}

float mixed(vec4 four, vec2 part) {
    vec2 rows = mix(four.wx, four.zy, part.x);
    return mix(rows.x, rows.y, part.y);
}

float height_at(vec2 offset) {
    Between b = between(offset);
    return mixed(textureGather(features, b.corner, 0), b.part);
}

float singularity_at(vec2 offset) {
    Between b = between(offset);
    return mixed(textureGather(features, b.corner, 3), b.part);
}

vec2 twice_angle_at(vec2 offset) {
    Between b = between(offset);
    return vec2(mixed(textureGather(features, b.corner, 1), b.part), mixed(textureGather(features, b.corner, 2), b.part));
}
