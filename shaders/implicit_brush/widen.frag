#version 450 core
// Smooths along one axis with a binomial of REACH pixels to either side, a variance of REACH / 2: no insulators.
layout(binding = 0) uniform sampler2D field;

uniform ivec2 axis;
uniform ivec4 area;                 // first and last pixel of the field
uniform float weights[REACH + 1];   // of the middle, and outwards

layout(location = 0) out vec4 out_field;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = weights[0] * texelFetch(field, pixel, 0);
    for (int i = 1; i <= REACH; ++i)
        sum += weights[i] * (texelFetch(field, clamp(pixel + i * axis, area.xy, area.zw), 0) +
                             texelFetch(field, clamp(pixel - i * axis, area.xy, area.zw), 0));
    out_field = sum;
}
