#version 450 core
// Tone shading of Gooch 1998, section 4.2, per pixel.
#include "surface/surface.glsl"
#include "common/lights.glsl"

uniform float b;
uniform float y;
uniform float alpha;
uniform float beta;
uniform float highlight;
uniform float shininess;

void main() {
    vec3 k_d = surface_color();
    vec3 n = surface_normal();
    vec3 l = towards_light(0, world_position);

    vec3 k_cool = vec3(0.0, 0.0, b) + alpha * k_d; // equation 3
    vec3 k_warm = vec3(y, y, 0.0) + beta * k_d;
    float warm = 0.5 + 0.5 * dot(l, n);
#ifdef PRINTED_EQUATION
    warm = 1.0 - warm; // equation 2 to the letter; it puts k_cool on the lit side
#endif
    vec3 color = mix(k_cool, k_warm, warm);

#ifdef HIGHLIGHT
    // Phong's term, drawn towards white ("a single light source provides white highlights", section 3).
    float specular = max(dot(reflect(-l, n), towards_eye(world_position)), 0.0);
    color = mix(color, lights[0].color.rgb, highlight * pow(specular, shininess));
#endif
    write_surface(color, n);
}
