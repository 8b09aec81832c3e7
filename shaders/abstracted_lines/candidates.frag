#version 450 core
// The pixels that can have a line, by the first fit alone. Their depth says in which channels, and the search is done
// for those pixels and channels: a quarter of the pixels of a model, and the specular channel of hardly any. Software
// renderers execute both sides of a branch, so that inside of the search nothing could be saved; pixels that fail a
// depth test cost nothing anywhere.
// Define: WHOLE_SPACING, texels.

layout(binding = 0) uniform sampler2D tones;

uniform vec4 thresholds; // c_l of dark and highlight lines of the diffuse tone, then of the specular one
uniform float slack;     // below 1 where the search's own taps lie between texels

vec2 texel_at(ivec2 texel) { return texelFetch(tones, clamp(texel, ivec2(0), textureSize(tones, 0) - 1), 0).rg; }
vec2 tone_at(vec2 place) { return texel_at(ivec2(place)); }

#include "abstracted_lines/fit.glsl"
#include "abstracted_lines/guard.glsl"

void main() {
    Fit f = fit_here(ivec2(gl_FragCoord.xy));
    vec2 mean = 0.5 * (f.xx + f.yy), difference = 0.5 * (f.xx - f.yy);
    vec2 root = sqrt(difference * difference + f.xy * f.xy);
    // The search looks at the eigenvalue of larger magnitude.
    vec2 curvature = mix(mean + root, mean - root, lessThan(mean, vec2(0.0)));
    vec4 least = slack * rim_part * thresholds;
    bool diffuse = curvature.x >= least.x || -curvature.x >= least.y;
    bool specular = curvature.y >= least.w || -curvature.y >= least.z;
    if (!diffuse && !specular) discard;
    gl_FragDepth = 0.25 * ((diffuse ? 1.0 : 0.0) + (specular ? 2.0 : 0.0));
}
