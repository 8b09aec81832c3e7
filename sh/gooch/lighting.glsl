// What the lights of the frame do at a point of a surface, before it is turned into colour: per pixel, or per vertex.
// docs/gooch.md has the formulas.
#include "common/lights.glsl"

uniform float highlight;
uniform float shininess;

float brightest(vec3 color) { return max(color.r, max(color.g, color.b)); }

// Phong's exponential term for light from l.
float phong_term(vec3 l, vec3 n, vec3 v) { return pow(max(dot(reflect(-l, n), v), 0.0), shininess); }

// Of the lights' strengths: x: how much reaches the point; y: times max(0, l.n); z: times max(0, -l.n). Never above 1: in
// sum as much as the strongest light, or a mean.
vec3 tone_light(vec3 world, vec3 n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        float s = brightest(lights[i].color.rgb) * light_reach(i, world);
        float facing = dot(towards_light(i, world), n);
        sum += s * vec3(1.0, max(facing, 0.0), max(-facing, 0.0));
    }
    return sum / max(sum.x, 1.0);
}

// Lays every light's highlight over a colour, each in its light's hue, in no order.
vec3 lay_highlights(vec3 color, vec3 world, vec3 n) {
    vec3 v = towards_eye(world), hues = vec3(0.0);
    float through = 1.0, sum = 0.0;
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 weighted = highlight * phong_term(towards_light(i, world), n, v) * light_reach(i, world) * lights[i].color.rgb;
        float share = brightest(weighted);
        hues += weighted;
        sum += share;
        through *= 1.0 - share;
    }
    return sum > 0.0 ? mix(color, hues / sum, 1.0 - through) : color;
}

// The sums of Phong's model over the lights: l.n where it is positive, and the exponential term.
vec3 diffuse_light(vec3 world, vec3 n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHT_COUNT; ++i)
        sum += light_reach(i, world) * max(dot(towards_light(i, world), n), 0.0) * lights[i].color.rgb;
    return sum;
}

vec3 specular_light(vec3 world, vec3 n) {
    vec3 sum = vec3(0.0), v = towards_eye(world);
    for (int i = 0; i < LIGHT_COUNT; ++i)
        sum += light_reach(i, world) * phong_term(towards_light(i, world), n, v) * lights[i].color.rgb;
    return highlight * sum;
}
