#version 450 core
// The tone image: how the scene is lit, diffuse and specular apart, so that broad diffuse tones don't mask highlights
// (section 1). Any number of lights: what the first leaves dark the second lights up, which stays below white without an
// edge where it is reached.
#include "surface/surface.glsl"
#include "surface/abstracted_normal.glsl"
#include "common/lights.glsl"

uniform float wrap;
uniform float albedo;
uniform float shininess;
#ifdef WIDTHS
#include "abstracted_lines/widest_line.glsl"
uniform float full_width;          // px
uniform float least_width;         // px
uniform float full_width_distance; // metres; 0: width does not depend on distance
#ifdef WIDTH_FACTORS_UNIT
in float width_factor;
#endif

// Distance from the eye; in an orthographic view, from its plane.
float eye_distance() {
    return eye.w > 0.0 ? distance(eye.xyz, world_position) : -(view_from_world * vec4(world_position, 1.0)).z;
}

float line_width() {
    float width = full_width;
    if (full_width_distance > 0.0) width *= min(full_width_distance / max(eye_distance(), 1e-9), 1.0);
#ifdef WIDTH_FACTORS_UNIT
    width *= clamp(width_factor, 0.0, 1.0);
#endif
    return max(width, least_width);
}
#endif

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
    vec3 n = shading_normal(surface_normal());
    vec3 v = towards_eye(world_position);
    float unlit = 1.0, dull = 1.0; // what light has not reached yet
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 l = towards_light(i, world_position);
        vec3 color = lights[i].color.rgb;
        float strength = max(color.r, max(color.g, color.b)) * light_reach(i, world_position);
        unlit *= 1.0 - clamp(strength * max((dot(n, l) + wrap) / (1.0 + wrap), 0.0), 0.0, 1.0);
        vec3 half_vector = l + v;
        float cosine = dot(n, half_vector) * inversesqrt(max(dot(half_vector, half_vector), 1e-12));
        float shine = pow(max(cosine, 0.0), shininess) * smoothstep(0.0, 0.1, dot(n, l));
        dull *= 1.0 - clamp(strength * shine, 0.0, 1.0);
    }
    // Its root, as sRGB nearly has it: greys as the eye sees them.
    float own = sqrt(clamp(luminance(surface_color()), 0.0, 1.0));
    vec2 tone = vec2((1.0 - unlit) * mix(1.0, own, albedo), 1.0 - dull);
#ifdef WIDTHS
    out_color = vec4(tone, line_width() / widest_line, 1.0);
#else
    out_color = vec4(tone, 0.0, 1.0);
#endif
}
