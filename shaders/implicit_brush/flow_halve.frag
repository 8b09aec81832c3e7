#version 450 core
// Two pictures side by side in red and green, at half the size: by weights 1 3 3 1.
#ifdef TWO_PICTURES
layout(binding = 0) uniform sampler2D before;
layout(binding = 1) uniform sampler2D now;
#else
layout(binding = 0) uniform sampler2D both;
#endif

layout(location = 0) out vec2 tones;

vec2 tones_at(ivec2 pixel) {
#ifdef TWO_PICTURES
    ivec2 place = clamp(pixel, ivec2(0), textureSize(now, 0) - 1);
    return vec2(texelFetch(before, place, 0).r, texelFetch(now, place, 0).r);
#else
    return texelFetch(both, clamp(pixel, ivec2(0), textureSize(both, 0) - 1), 0).rg;
#endif
}

void main() {
    const float weights[4] = float[4](0.125, 0.375, 0.375, 0.125);
    ivec2 corner = 2 * ivec2(gl_FragCoord.xy) - 1;
    tones = vec2(0.0);
    for (int i = 0; i < 16; ++i) tones += weights[i % 4] * weights[i / 4] * tones_at(corner + ivec2(i % 4, i / 4));
}
