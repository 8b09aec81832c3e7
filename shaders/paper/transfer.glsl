// How much of a pigment stays on paper: peaks of its relief catch it, valleys resist it (Kalnins et al. 2002, media
// simulation). Heights are spread evenly over [0, 1], so that the mean over any flat tone is that tone.
#include "common/half_covered.glsl"

layout(binding = 0) uniform sampler2D heights; // a texel a pixel, repeated, not filtered

uniform float strength; // of the effect
uniform float pressure; // 1 keeps tones
uniform float softness; // of the passage from bare to covered, in heights; above 0, at most 1

float paper_height() {
    return (255.0 * textureLod(heights, gl_FragCoord.xy / vec2(textureSize(heights, 0)), 0.0).r + 0.5) / 256.0;
}

// What is left of a coverage by pigment, from 0 to 1, at this pixel.
float caught(float amount) {
    amount = clamp(amount, 0.0, 1.0);
    float level = half_covered(pressure * amount, softness);
    return mix(amount, clamp((paper_height() - level) / softness + 0.5, 0.0, 1.0), strength);
}
