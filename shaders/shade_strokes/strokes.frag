#version 450 core
// How much of a pixel a stroke covers where the surface is seen, premultiplied with its colour.
#include "common/view.glsl"
#include "shade_strokes/grain.glsl"

layout(binding = 0) uniform sampler2D depth_buffer;

noperspective in vec3 center;
noperspective in vec3 place;
flat in vec2 turn;
noperspective in vec2 part;
noperspective in float half_width;
flat in float alpha;
flat in float finer;

uniform vec3 color;
uniform float opacity;
uniform float lift;    // how much lighter a stroke is at its ends than in its middle: the hand turns there
uniform float hugging; // metres by which strokes may be off the surface

layout(location = 0) out vec4 out_line;
#ifdef COVERAGE
layout(location = 1) out vec4 out_coverage;
#endif

const float BAREST = 0.002; // that a stroke leaves, or a part of it would say nothing of the whole
const float STEEPEST = 8.0; // 1 / cosine of the angle of sight from which on no more is allowed for

// A box filter one pixel wide along the line, `beyond` its ends.
float ends(vec2 beyond) {
    vec2 to = clamp(place.yz + beyond, -0.5, 0.5);
    return max(to.x + to.y, 0.0);
}

// The same across it; what is thinner than a pixel keeps its width as opacity, so that ink stays.
float covered(float aside) {
    float across = clamp(half_width - abs(aside) + 0.5, 0.0, min(1.0, 2.0 * half_width));
    return across * ends(1.0 - turn);
}

float scene_at(ivec2 pixel) {
    return texelFetch(depth_buffer, clamp(pixel, ivec2(0), textureSize(depth_buffer, 0) - 1), 0).r;
}

// How depth changes from pixel to pixel: much as over the side where it does less, which is the surface's own.
float slope_at(ivec2 pixel, ivec2 axis, float here) {
    float ahead = scene_at(pixel + axis) - here, behind = here - scene_at(pixel - axis);
    float squares = ahead * ahead + behind * behind;
    return squares > 0.0 ? ahead * behind * (ahead + behind) / squares : 0.0;
}

// Whether the line's middle is on the surface that a pixel shows, as far as strokes hug it: 1, and less where it is
// farther behind it. Depth in the window is linear over a triangle, so the slope says how deep its plane is at the very
// point, and how much of an error along the normal is one along the line of sight.
float on_surface(ivec2 pixel, vec2 from_pixel, float depth, float nearest) {
    float scene = scene_at(pixel);
    if (scene <= nearest) return 1.0; // mostly: a slope only allows for more
    float surface = view_depth(scene);
    vec2 slope = vec2(slope_at(pixel, ivec2(1, 0), scene), slope_at(pixel, ivec2(0, 1), scene));
    vec2 rise = vec2(view_depth(max(scene + slope.x, 1e-9)), view_depth(max(scene + slope.y, 1e-9))) - surface;
    float metres = pixel_size * (eye.w > 0.0 ? surface : 1.0); // of a pixel
    float steep = min(sqrt(1.0 + dot(rise, rise) / (metres * metres)), STEEPEST);
    float plane = view_depth(max(scene + dot(slope, from_pixel), 1e-9));
    float limit = max(surface + hugging, plane + hugging * steep);
    return clamp(1.0 + (limit - depth) / hugging, 0.0, 1.0);
}

// Of a quadratic B-spline at the pixels before, at and behind a place, `f` pixels from the middle one.
vec3 spline(float f) { return vec3(0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f)); }

// How much of the line's middle is seen: of the pixels around it, so that strokes come out from behind a silhouette,
// which takes whole pixels, in parts.
float visible() {
    ivec2 base = ivec2(floor(center.xy));
    vec2 f = center.xy - 0.5 - vec2(base);
    vec3 across = spline(f.x), up = spline(f.y);
    float depth = view_depth(center.z), nearest = window_depth(max(depth - hugging, 1e-6)), seen = 0.0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            ivec2 aside = ivec2(x, y) - 1;
            seen += across[x] * up[y] * on_surface(base + aside, f - vec2(aside), depth, nearest);
        }
    return seen;
}

void main() {
    float coverage = covered(place.x);
    // A parabola over the way from turn to turn, of mean 1.
    vec2 middle = 2.0 * part - 1.0;
    float lifted = lift * mix(middle.y * middle.y, middle.x * middle.x, finer);
    coverage *= alpha * (1.0 - lifted) / (1.0 - lift / 3.0);
    if (coverage <= 0.0) discard;
    coverage = opacity * on_paper(min(coverage, 1.0)) * visible();
    // Where a stroke goes on in the next segment, both draw a part; in parts of the density, what is left bare by one
    // part over the other is what the whole stroke leaves.
    float share = ends(vec2(0.0)) / ends(1.0 - turn);
    if (share < 1.0) coverage = 1.0 - pow(max(1.0 - coverage, BAREST), share);
    out_line = vec4(color, 1.0) * coverage;
#ifdef COVERAGE
    out_coverage = vec4(coverage);
#endif
}
