#version 450 core
// Tones of what is seen (components/picture.h), and whether there is anything. Define: PICTURES where there are some.
layout(binding = 0) uniform sampler2D colors; // linear
layout(binding = 1) uniform sampler2D depth_buffer;
#ifdef PICTURES
layout(binding = 2) uniform sampler2D picture_tones;
#endif

uniform ivec4 pictures; // first and last pixel of pictures

layout(location = 0) out vec2 out_tone;

float encoded(float light) { // as sRGB has it
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1.0 / 2.4) - 0.055;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(depth_buffer, pixel, 0).r > 0.0) {
        float light = dot(texelFetch(colors, pixel, 0).rgb, vec3(0.2126, 0.7152, 0.0722));
        out_tone = vec2(encoded(clamp(light, 0.0, 1.0)), 1.0);
        return;
    }
#ifdef PICTURES
    bool inside = all(greaterThanEqual(pixel, pictures.xy)) && all(lessThanEqual(pixel, pictures.zw));
    out_tone = inside ? vec2(texelFetch(picture_tones, pixel, 0).r, 1.0) : vec2(0.0);
#else
    out_tone = vec2(0.0);
#endif
}
