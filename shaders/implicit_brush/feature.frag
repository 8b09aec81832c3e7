#version 450 core
// Height h and direction theta of a feature at each pixel (table 1), as h, cos and sin of twice theta's angle. Alpha is
// the contour's insulation. Define: FEATURE, a value of BrushFeature; LUMINANCE where slopes are those of tones.
// Heights of curvature are that over a window, of its change over two: numbers that a change of scale leaves alone.
#include "implicit_brush/slope_texel.glsl"
#include "implicit_brush/gradient.glsl"
#include "implicit_brush/window.glsl"

#define CONTOURS 0
#define SURFACE_EDGES 1
#define LUMINANCE_EDGES 2
#define RIDGES 3
#define VALLEYS 4
#define INFLECTIONS 5

layout(location = 0) out vec4 out_feature;

// The relief of luminance is as high where it is white as the window is wide.
float relief_scale(ivec2 pixel) {
#ifdef LUMINANCE
    return window_at(pixel);
#else
    return 1.0;
#endif
}

vec2 twice_angle(vec2 v) {
    float square = dot(v, v);
    return square > 0.0 ? vec2(v.x * v.x - v.y * v.y, 2.0 * v.x * v.y) / square : vec2(0.0);
}

#if FEATURE == RIDGES || FEATURE == VALLEYS
// The curvature tensor H = -grad slope, symmetrised: interpolated and bumped normals are those of no surface. Convex is
// positive.
vec4 feature_of(ivec2 pixel, vec4 here) {
    Normal fit = Normal(0.0, 0.0, 0.0);
    vec2 sum_x = vec2(0.0), sum_y = vec2(0.0);
    for (int i = 0; i < 8; ++i) {
        vec4 there = slope_at(pixel + around[i]);
        vec2 d = vec2(around[i]);
        float weight = around_weight(i) * free(there);
        add(fit, d, weight);
        sum_x += weight * (there.x - here.x) * d;
        sum_y += weight * (there.y - here.y) * d;
    }
    vec2 gx = gradient(fit, sum_x), gy = gradient(fit, sum_y);
    float mean = -0.5 * (gx.x + gy.y);
    vec2 anisotropy = -0.5 * vec2(gx.x - gy.y, gx.y + gy.x);
    float size = length(anisotropy);
    vec2 along_most = size > 0.0 ? anisotropy / size : vec2(0.0);
#if FEATURE == RIDGES
    return vec4(window_at(pixel) * (mean + size), along_most, here.b);
#else
    return vec4(window_at(pixel) * (size - mean), -along_most, here.b);
#endif
}
#elif FEATURE == INFLECTIONS
// The gradient of mean curvature, half the divergence of the slope, from differences over two pixels. Where one of the
// nine pixels is cut off its slope is taken for the middle's: nothing changes that way.
vec4 feature_of(ivec2 pixel, vec4 here) {
#define S(x, y) mix(here.xy, near[3 * ((y) + 1) + (x) + 1].xy, near[3 * ((y) + 1) + (x) + 1].z)
    vec3 near[9]; // slope, and how much it counts
    for (int i = 0; i < 9; ++i) {
        vec4 there = slope_at(pixel + ivec2(i % 3 - 1, i / 3 - 1));
        near[i] = vec3(there.xy, free(there));
    }
    vec4 east = slope_at(pixel + ivec2(2, 0)), west = slope_at(pixel - ivec2(2, 0));
    vec4 north = slope_at(pixel + ivec2(0, 2)), south = slope_at(pixel - ivec2(0, 2));
    vec2 e = mix(here.xy, east.xy, free(east)), w = mix(here.xy, west.xy, free(west));
    vec2 n = mix(here.xy, north.xy, free(north)), s = mix(here.xy, south.xy, free(south));
    float cross_y = S(1, 1).y - S(1, -1).y - S(-1, 1).y + S(-1, -1).y;
    float cross_x = S(1, 1).x - S(1, -1).x - S(-1, 1).x + S(-1, -1).x;
    vec2 change = -0.125 * vec2(e.x - 2.0 * here.x + w.x + cross_y, n.y - 2.0 * here.y + s.y + cross_x);
    float width = window_at(pixel);
    return vec4(width * width * length(change), twice_angle(change), here.b);
}
#elif FEATURE == CONTOURS
uniform float peak; // of a straight contour, smoothed
vec4 feature_of(ivec2 pixel, vec4 tensor) {
    float size = length(tensor.gb);
    return vec4(tensor.r / peak, size > 0.0 ? tensor.gb / size : vec2(0.0), 0.0);
}
#else
vec4 feature_of(ivec2 pixel, vec4 here) { return vec4(length(here.xy), twice_angle(here.xy), here.b); }
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 here = slope_at(pixel);
    out_feature = vec4(0.0, 0.0, 0.0, here.b);
    if (here.a <= 0.0) return;
    vec4 feature = feature_of(pixel, here);
    out_feature = vec4(min(relief_scale(pixel) * feature.x, 6e4), feature.yzw);
}
