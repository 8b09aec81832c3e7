#version 450 core
// Where what a picture shows was when the noise of each phase was made, as past.frag has it for surfaces.

layout(binding = 0) uniform sampler2D map_0;
layout(binding = 1) uniform sampler2D map_1;

uniform ivec2 corner;  // pixel of the view at the lower left one of the maps
uniform vec4 phase[2]; // random shift, pixels; weight

layout(location = 0) out vec4 out_past_0;
layout(location = 1) out vec4 out_past_1;

// Pixels on either side by which maps are compared with ones that only turn and scale.
const int reach = 4;

vec4 past(sampler2D map, vec4 phase) {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - corner, outermost = textureSize(map, 0) - 1;
    ivec2 low = max(pixel - reach, ivec2(0)), high = min(pixel + reach, outermost);
    vec2 size = vec2(max(high - low, ivec2(1)));
    vec2 left = texelFetch(map, ivec2(low.x, pixel.y), 0).xy, right = texelFetch(map, ivec2(high.x, pixel.y), 0).xy;
    vec2 below = texelFetch(map, ivec2(pixel.x, low.y), 0).xy, above = texelFetch(map, ivec2(pixel.x, high.y), 0).xy;
    vec2 across = (right - left) / size.x, up = (above - below) / size.y;
    float area = max(across.x * up.y - across.y * up.x, 1e-6);
    // Half the sum of the stretch and its inverse, 1 for no stretch: edges of what moves, and cuts, leave maps that are
    // no good for noise.
    float stretch = 0.5 * (dot(across, across) + dot(up, up)) / area;
    float trust = 1.0 - smoothstep(1.5, 4.0, stretch);
    return vec4(texelFetch(map, pixel, 0).xy + phase.xy, 0.5 * log2(area), phase.z * trust);
}

void main() {
    out_past_0 = past(map_0, phase[0]);
    out_past_1 = past(map_1, phase[1]);
}
