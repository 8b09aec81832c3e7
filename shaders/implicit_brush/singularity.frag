#version 450 core
// Where theta is singular: its mean change to the 8 pixels around (gamma_theta, section 3.2.1). Contours are singular,
// too (gamma_d), and the pixels beside them, whose features are made of slopes on one side alone.
layout(binding = 0) uniform sampler2D features;

uniform ivec4 area;

layout(location = 0) out vec4 out_feature;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 here = texelFetch(features, pixel, 0);
    float alike = 0.0, insulation = here.a;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            if (x == 0 && y == 0) continue;
            vec4 there = texelFetch(features, clamp(pixel + ivec2(x, y), area.xy, area.zw), 0);
            insulation = max(insulation, there.a);
            // |cos| of an angle from the cosine of twice it. No direction is as good as any.
            alike += sqrt(max(0.5 + 0.5 * dot(here.gb, there.gb), 0.0));
        }
    out_feature = vec4(here.rgb, clamp(max(1.0 - 0.125 * alike, insulation), 0.0, 1.0));
}
