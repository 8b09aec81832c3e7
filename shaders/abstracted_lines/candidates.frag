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
float tone_at(vec2 offset) { return texel_at(ivec2(gl_FragCoord.xy + offset)).r; }

#include "abstracted_lines/fit.glsl"
#include "abstracted_lines/guard.glsl"

void main() {
    Fit of_diffuse, of_specular;
    fit_here(ivec2(gl_FragCoord.xy), of_diffuse, of_specular);
    vec2 curvature = vec2(curvature_of(of_diffuse), curvature_of(of_specular));
    vec4 least = slack * rim_part * thresholds;
    bool diffuse = curvature.x >= least.x || -curvature.x >= least.y;
    bool specular = curvature.y >= least.w || -curvature.y >= least.z;
    if (!diffuse && !specular) discard;
    gl_FragDepth = 0.25 * ((diffuse ? 1.0 : 0.0) + (specular ? 2.0 : 0.0));
}
