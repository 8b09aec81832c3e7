#version 450 core
// The pixels that can have a line that somebody wants: h reaches the least height on the way that a pixel looks along
// theta. Their depth says so, 1/2, or 1 where theta is singular nearby, and profiles are looked for nowhere else: a
// software renderer executes both sides of a branch, but pixels that fail a depth test cost nothing anywhere.
#include "implicit_brush/profile_texel.glsl"

uniform float least_height;
uniform float reach;          // px
uniform float most_singular;

vec4 feature_at(vec2 offset) {
    return texelFetch(features, clamp(ivec2(gl_FragCoord.xy + offset), area.xy, area.zw), 0);
}

void main() {
    vec4 here = feature_at(vec2(0.0));
    vec2 theta = direction_of(here.gb);
    float highest = here.r, singular = here.a;
    float steps = ceil(reach / 1.5), spacing = reach / max(steps, 1.0);
    for (float i = 1.0; i <= steps; i += 1.0) {
        vec4 before = feature_at(-i * spacing * theta), after = feature_at(i * spacing * theta);
        highest = max(highest, max(before.r, after.r));
        if (i * spacing <= 2.0) singular = max(singular, max(before.a, after.a));
    }
    if (!(highest >= least_height && highest > 0.0)) discard;
    gl_FragDepth = singular > most_singular ? 1.0 : 0.5;
}
