#version 450 core
// Slopes of pixels from those of 2 x 2 samples each. Define: BREAKS where they are those of breaks.
layout(binding = 0) uniform sampler2D fine;

layout(location = 0) out vec4 out_slope;

void main() {
    ivec2 corner = 2 * ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    float insulation = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec4 s = texelFetch(fine, corner + ivec2(i & 1, i >> 1), 0);
        sum += vec4(s.a * s.rg, 0.0, s.a);
        insulation = max(insulation, s.b);
    }
#ifdef BREAKS
    // Two rows of samples beside a break are one row of pixels: half of what the mean leaves of two.
    out_slope = vec4(0.5 * sum.rg, 0.0, 1.0);
#else
    out_slope = vec4(sum.rg / max(sum.a, 1.0), insulation, min(sum.a, 1.0));
#endif
}
