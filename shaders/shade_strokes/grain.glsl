// The tooth of paper that a broad and dry tip, charcoal, shows by itself.
#include "common/half_covered.glsl"

uniform float grain; // of the effect, from 0 to 1

float hash(ivec2 texel) {
    uint x = uint(texel.x) * 0x9e3779b9u ^ uint(texel.y) * 0x85ebca6bu;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return float((x ^ (x >> 16)) >> 8) / 16777216.0;
}

// Heights that are evenly spread over [0, 1], a little larger than pixels.
float tooth() {
    vec2 place = gl_FragCoord.xy / 1.7;
    ivec2 low = ivec2(floor(place));
    vec2 f = place - vec2(low);
    vec2 w = f * f * (3.0 - 2.0 * f);
    float sum = mix(mix(hash(low), hash(low + ivec2(1, 0)), w.x),
                    mix(hash(low + ivec2(0, 1)), hash(low + ivec2(1, 1)), w.x), w.y) - 0.5;
    // Its variance is that of one number, times what the four weights leave of it.
    vec2 left = w * w + (1.0 - w) * (1.0 - w);
    float deviation = sqrt(left.x * left.y / 12.0);
    return 1.0 / (1.0 + exp(-1.7 * sum / deviation)); // about the normal distribution
}

// Peaks catch what valleys miss; the mean over the paper is `amount`.
float on_paper(float amount) {
    if (grain <= 0.0) return amount;
    const float softness = 0.3;
    float caught = clamp((tooth() - half_covered(amount, softness)) / softness + 0.5, 0.0, 1.0);
    return mix(amount, caught, grain);
}
