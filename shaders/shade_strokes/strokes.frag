#version 450 core
// How much of a pixel a stroke covers where the surface is seen, premultiplied with its colour.
#include "common/view.glsl"
#include "shade_strokes/grain.glsl"

layout(binding = 0) uniform sampler2D depth_buffer;

noperspective in vec3 center;
noperspective in vec3 place;
noperspective in vec2 lean;
flat in vec2 beyond;
noperspective in vec2 part;
noperspective in float half_width;
noperspective in vec2 taper;
flat in vec2 free;
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
const float TAPER = 0.35;   // of the width, where a chain ends
const float RISE = 2.0;     // metres towards the eye over metres aside, of surfaces that hide nothing beside them
const float STEEPEST = 8.0; // 1 / cosine of the angle of sight from which on no more is allowed for

// A box filter one pixel wide along the line, so far beyond its ends.
float ends(vec2 farther) {
    vec2 to = clamp(place.yz + farther, -0.5, 0.5);
    return max(to.x + to.y, 0.0);
}

// The same across it; what is thinner than a pixel keeps its width as opacity, so that ink stays.
float covered(float aside) {
    vec2 narrow = 1.0 - free * (1.0 - TAPER) * clamp(1.0 - taper, 0.0, 1.0);
    float half_ = half_width * narrow.x * narrow.y;
    float across = clamp(half_ - abs(aside) + 0.5, 0.0, min(1.0, 2.0 * half_));
    return across * ends(beyond);
}

const int ROWS = 3 * SAMPLES; // of samples, that count

// Of a quadratic B-spline three pixels wide, at two samples.
vec2 spline(float samples) {
    vec2 t = abs(vec2(samples, samples + 1.0)) / float(SAMPLES);
    vec2 tail = max(1.5 - t, 0.0);
    return mix(0.5 * tail * tail, 0.75 - t * t, lessThan(t, vec2(0.5)));
}

// How far in front of the line's middle two samples, so many away from it along an axis, may be, in samples: as the
// plane has it that it is on, or any that is not steeper than RISE.
vec2 rise(float samples, float lean_) {
    vec2 aside = vec2(samples, samples + 1.0);
    return max(lean_ * aside, 0.0) + RISE * abs(aside);
}

// How much of the line's middle is seen: of the samples around it, so that strokes come out from behind a silhouette,
// which takes whole samples, in parts. Depths are the window's, in which planes are planes, over that of `hugging`.
float visible() {
    vec2 at = center.xy * float(SAMPLES) - 0.5;
    vec2 first = floor(at - 0.5 * float(ROWS)) + 1.0;
    vec2 aside = first - at;
    float depth = view_depth(center.z);
    float unit = 1.0 / max(center.z - window_depth(depth + hugging), 1e-9);
    float size = pixel_size / float(SAMPLES) * (eye.w > 0.0 ? depth : 1.0) / hugging;
    float front = center.z * unit + min(sqrt(1.0 + dot(lean, lean)), STEEPEST) + 1.0, seen = 0.0;
    vec2 texel = 1.0 / vec2(textureSize(depth_buffer, 0));
    for (int y = 0; y < ROWS; y += 2) {
        vec2 up = front + size * rise(aside.y + float(y), lean.y);
        vec2 row = vec2(0.0);
        for (int x = 0; x < ROWS; x += 2) {
            vec2 across = size * rise(aside.x + float(x), lean.x);
            vec4 scene = unit * textureGather(depth_buffer, (first + vec2(x, y) + 1.0) * texel);
            vec2 weight = spline(aside.x + float(x));
            row.x += dot(weight, clamp(across + up.x - scene.wz, 0.0, 1.0));
            row.y += dot(weight, clamp(across + up.y - scene.xy, 0.0, 1.0));
        }
        seen += dot(row, spline(aside.y + float(y)));
    }
    return seen / float(SAMPLES * SAMPLES);
}

void main() {
    float coverage = covered(place.x);
    // A parabola over the way from turn to turn, of mean 1.
    vec2 middle = 2.0 * part - 1.0;
    float lifted = lift * mix(middle.y * middle.y, middle.x * middle.x, finer);
    coverage *= alpha * (1.0 - lifted) / (1.0 - lift / 3.0);
    // Where a line goes on in the next piece, both draw a part; in parts of the density, what is left bare by one part
    // over the other is what the whole stroke leaves.
    float share = ends(vec2(0.0)) / max(ends(beyond), 1e-6);
    if (coverage <= 0.0 || share <= 0.0) discard;
    coverage = opacity * on_paper(min(coverage, 1.0)) * visible();
    if (share < 1.0) coverage = 1.0 - pow(max(1.0 - coverage, BAREST), share);
    out_line = vec4(color, 1.0) * coverage;
#ifdef COVERAGE
    out_coverage = vec4(coverage);
#endif
}
