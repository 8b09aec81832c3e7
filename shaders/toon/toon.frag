#version 450 core
// Cel shading: the sum of all light, cut into tones (Barla et al. 2006 for detail and abstracted normals).
#include "surface/surface.glsl"
#include "surface/abstracted_normal.glsl"
#include "common/bands.glsl"
#include "common/constants.glsl"
#include "common/tone.glsl"
#include "toon/detail.glsl"
#include "toon/tones.glsl"

uniform float wrap;
#ifdef RIM
uniform float rim;
uniform float rim_width;
uniform float rim_edge; // the tone below which there is none
uniform vec3 rim_color;
#endif
#ifdef SPECULAR
uniform float specular;
uniform float specular_size;
uniform vec3 specular_color;
#endif

#ifdef SPECULAR
// Blinn-Phong's terms of all lights are summed, then cut where one alone would be at `specular_size` from the normal.
// (n.h)^m is nearly exp(-m angle^2 / 2): taken back to an angle, relative to the edge, it is even enough to be filtered.
float highlight_angle(vec3 n, vec3 v) {
    float exponent = 2.0 * log(2.0) / (specular_size * specular_size);
    float sum = 0.0;
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 l = towards_light(i, world_position);
        vec3 half_vector = l + v;
        float cosine = dot(n, half_vector) * inversesqrt(max(dot(half_vector, half_vector), 1e-12));
        vec3 color = lights[i].color.rgb;
        sum += max(color.r, max(color.g, color.b)) * light_reach(i, world_position) *
               smoothstep(0.0, 0.1, dot(n, l)) * pow(max(cosine, 0.0), exponent);
    }
    return sqrt(max(-log(max(sum, 1e-30)), 0.0) / log(2.0));
}

// A highlight much smaller than a pixel covers the part of it that its disc does.
float highlight_band(float angle, float width) {
    return min(filtered_step(1.0 - angle, width, 0.0), PI / (width * width));
}
#endif

void main() {
    // All that is differentiated comes first: surface_color() may discard.
    vec3 n = surface_normal();
    vec3 v = towards_eye(world_position);
    vec3 shading = shading_normal(n);
    Tone tone = light_tone(world_position, shading, wrap);
    float width = pixel_width(tone.sum);
#ifdef RIM
    float away = 1.0 - abs(dot(n, v));
    float rim_band = rim * filtered_step(away - (1.0 - rim_width), pixel_width(away), 0.0) *
                     filtered_step(tone.sum - rim_edge, width, 0.0);
#endif
#ifdef SPECULAR
    float angle = highlight_angle(shading, v);
    float highlight = specular * highlight_band(angle, pixel_width(angle));
#endif
    vec3 k_d = surface_color();

    vec3 color = tone_color(tone.sum, width, tone_detail(n, v));
#ifndef TONES_REPLACE
    color *= k_d;
#endif
#ifdef RIM
    color = mix(color, rim_color, rim_band);
#endif
#ifdef SPECULAR
    color = mix(color, specular_color, highlight);
#endif
    write_surface(tone.color * color, n);
}
