#version 450 core
// Tone shading of Gooch 1998, section 4.2; its two-light approximation, section 4.4; and Phong's model, equation 1.
#include "surface/surface.glsl"
#include "gooch/lighting.glsl"

uniform float b;
uniform float y;
uniform float alpha;
uniform float beta;
uniform float ambient;
uniform float diffuse;

#ifdef PER_VERTEX
in vec3 front_light;
#ifdef PHONG
in vec3 front_shine;
#endif
#ifdef DOUBLE_SIDED
in vec3 back_light;
#ifdef PHONG
in vec3 back_shine;
#endif
#else
#define back_light front_light
#define back_shine front_shine
#endif
#endif

#ifdef PHONG

vec3 shade(vec3 k_d, vec3 n) {
#ifdef PER_VERTEX
    vec3 light = seen_from_behind() ? back_light : front_light;
    vec3 shine = seen_from_behind() ? back_shine : front_shine;
#else
    vec3 light = diffuse_light(world_position, n), shine = specular_light(world_position, n);
#endif
    return diffuse * k_d * (ambient + light) + shine; // equation 1, and Phong's highlight
}

#else

vec3 shade(vec3 k_d, vec3 n) {
    vec3 k_cool = vec3(0.0, 0.0, b) + alpha * k_d; // equation 3
    vec3 k_warm = vec3(y, y, 0.0) + beta * k_d;
#ifdef PRINTED_EQUATION
    vec3 swapped = k_cool; // equation 2 to the letter; it puts k_cool on the lit side
    k_cool = k_warm;
    k_warm = swapped;
#endif
#ifdef PER_VERTEX
    vec3 light = seen_from_behind() ? back_light : front_light;
#else
    vec3 light = tone_light(world_position, n);
#endif
#ifdef TWO_LIGHTS
    // Section 4.4: ambient light and two lights of opposite directions and colours; "we turn off the Phong highlight".
    vec3 first = 0.5 * (k_warm - k_cool), second = 0.5 * (k_cool - k_warm);
#ifdef CLAMP_LIGHTS
    first = max(first, 0.0);
    second = max(second, 0.0);
#endif
    return mix(k_cool, 0.5 * (k_cool + k_warm), light.x) + light.y * first + light.z * second;
#else
    vec3 color = mix(k_cool, k_warm, 0.5 * (light.x + light.y - light.z)); // equation 2
#ifdef HIGHLIGHT
    color = lay_highlights(color, world_position, n); // "a single light source provides white highlights", section 3
#endif
    return color;
#endif
}

#endif

void main() {
    vec3 k_d = surface_color();
    vec3 n = surface_normal();
    write_surface(shade(k_d, n), n);
}
