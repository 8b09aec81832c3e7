#version 450 core
// Slopes of the relief that brightness makes, of tone per pixel.
// Define: INSULATED where contours of surfaces cut neighbours off.
#include "implicit_brush/gradient.glsl"

layout(binding = 0) uniform sampler2D tones; // red: the tone; green: 1 where there is something
#ifdef INSULATED
layout(binding = 1) uniform sampler2D surface_slopes;
#endif

uniform ivec4 area;   // first and last pixel that have tones

layout(location = 0) out vec4 out_slope;

float insulation_at(ivec2 pixel) {
#ifdef INSULATED
    return texelFetch(surface_slopes, pixel, 0).b;
#else
    return 0.0;
#endif
}

// x: the tone; y: how much it counts. What is no number does not.
vec2 tone_at(ivec2 pixel) {
    ivec2 inside = clamp(pixel, area.xy, area.zw);
    vec2 t = texelFetch(tones, inside, 0).rg;
    bool valid = t.x > -1e3 && t.x < 1e3 && t.y > 0.5 && inside == pixel;
    return valid ? vec2(clamp(t.x, -4.0, 4.0), 1.0 - insulation_at(inside)) : vec2(0.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 here = tone_at(pixel);
    Normal fit = Normal(0.0, 0.0, 0.0);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 8; ++i) {
        vec2 there = tone_at(pixel + around[i]), d = vec2(around[i]);
        float weight = around_weight(i) * there.y;
        add(fit, d, weight);
        sum += weight * (there.x - here.x) * d;
    }
    vec2 slope = here.y > 0.0 ? gradient(fit, sum) : vec2(0.0);
    float insulation = insulation_at(pixel);
    out_slope = vec4(slope, insulation, here.y > 0.0 || insulation > 0.0 ? 1.0 : 0.0);
}
