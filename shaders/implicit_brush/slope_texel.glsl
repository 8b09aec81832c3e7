// A texel of slopes, of surfaces or of luminance: red and green the slope, blue how much a contour insulates the pixel,
// alpha how much of it there is. Beyond the rectangle that they were made for there is nothing.
layout(binding = 0) uniform sampler2D slopes;

uniform ivec4 area; // first and last pixel that have slopes

vec4 slope_at(ivec2 pixel) {
    vec4 s = texelFetch(slopes, clamp(pixel, area.xy, area.zw), 0);
    if (any(lessThan(pixel, area.xy)) || any(greaterThan(pixel, area.zw))) s.a = 0.0;
    return s;
}

// How freely a pixel exchanges with its neighbours.
float free(vec4 slope) { return slope.a * (1.0 - slope.b); }
