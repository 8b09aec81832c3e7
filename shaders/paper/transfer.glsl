// How much of a pigment stays on paper: peaks of its relief catch it, valleys resist it (Kalnins et al. 2002, media
// simulation). Heights are spread evenly over [0, 1], so that the mean over any flat tone is that tone.
layout(binding = 0) uniform sampler2D heights; // a texel a pixel, repeated, not filtered

uniform float strength; // of the effect
uniform float pressure; // 1 keeps tones
uniform float softness; // of the passage from bare to covered, in heights; above 0, at most 1

float paper_height() {
    return (255.0 * textureLod(heights, gl_FragCoord.xy / vec2(textureSize(heights, 0)), 0.0).r + 0.5) / 256.0;
}

// The height that is half covered by `amount`: a ramp of width s about it, clamped to [0, 1], has the mean `amount`
// over all heights. Towards the ends the ramp is cut off by the lowest valley or the highest peak.
float half_covered(float amount, float s) {
    if (amount < 0.5 * s) return 1.0 + 0.5 * s - sqrt(2.0 * s * amount);
    if (amount > 1.0 - 0.5 * s) return sqrt(2.0 * s * (1.0 - amount)) - 0.5 * s;
    return 1.0 - amount;
}

// What is left of a coverage by pigment, from 0 to 1, at this pixel.
float caught(float amount) {
    amount = clamp(amount, 0.0, 1.0);
    float level = half_covered(pressure * amount, softness);
    return mix(amount, clamp((paper_height() - level) / softness + 0.5, 0.0, 1.0), strength);
}
