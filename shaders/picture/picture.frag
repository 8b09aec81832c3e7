#version 450 core
// The base coat of a picture: its colours, its tones, its tones cut into flat ones, or nothing; premultiplied.
#include "common/bands.glsl"
#include "picture/mean.glsl"

#define SHOW_PICTURE 0
#define SHOW_TONE 1
#define SHOW_BANDS 2

layout(binding = 0) uniform sampler2D colors;
layout(binding = 1) uniform sampler2D tones;

uniform uint object_id;
uniform int bands;
uniform float softness;
uniform float smoothing; // pixels on each side
uniform float own_color;
uniform vec3 light; // encoded as the tone is
uniform vec3 shade;

layout(location = 0) out vec4 out_color;
#ifdef OUT_OBJECT_ID
layout(location = 2) out uint out_object_id;
#endif
#ifdef OUT_CODE
#include "surface/surface_code.glsl"
layout(location = 3) out uvec2 out_code;
#endif

vec3 decode(vec3 srgb) {
    return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThanEqual(srgb, vec3(0.04045)));
}

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

// Steps from 0 to 1, evenly spaced, each averaged over the pixel.
float banded(float tone) {
    float width = pixel_width(tone), steps = 0.0;
    for (int i = 1; i < bands; ++i)
        steps += filtered_step(tone - float(i) / float(bands), width, softness);
    return steps / float(bands - 1);
}

vec4 coat() {
#if SHOW == SHOW_PICTURE
    return picture_mean(colors, 0.0);
#elif SHOW == SHOW_TONE || SHOW == SHOW_BANDS
#if SHOW == SHOW_BANDS
    float tone = banded(picture_mean(tones, smoothing).r);
#else
    float tone = picture_mean(tones, 0.0).r;
#endif
    vec3 color = decode(mix(shade, light, tone));
#ifdef OWN_COLOR
    // The picture's hue at the luminance of the tone.
    vec4 own = picture_mean(colors, SHOW == SHOW_BANDS ? smoothing : 0.0);
    own.rgb += 1.0 - own.a;
    color = mix(color, own.rgb * (luminance(color) / max(luminance(own.rgb), 1e-4)), own_color);
#endif
    return vec4(color, 1.0);
#else
    return vec4(0.0);
#endif
}

void main() {
    out_color = coat();
#ifdef OUT_OBJECT_ID
    out_object_id = object_id;
#endif
#ifdef OUT_CODE
    out_code = uvec2(object_id, encode_normal(vec3(0.0, 0.0, 1.0)));
#endif
}
