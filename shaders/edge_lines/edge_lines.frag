#version 450 core
// Coverage of a line with round ends, where the point of the edge nearest to this pixel is visible. Testing the depth at
// the edge itself, not at the pixel, keeps a line whole across its width: no dashes on slanted surfaces, no leaks where
// the rim of a line lies over something nearer.
#include "common/view.glsl"

flat in vec4 segment;
flat in vec2 depths;

uniform vec3 color;
uniform float half_width;
layout(binding = 0) uniform sampler2D depth_buffer;

layout(location = 0) out vec4 out_line;

// How far an edge may lie behind what is drawn around it and still be seen, in pixels: a surface that comes towards the
// eye at up to 71 degrees, such as the ground before the foot of a wall, is that much nearer one pixel on.
const float TOLERANCE = 3.0;

// Whether a point at window depth `depth` is in front of enough of what is around pixel `at`. On a silhouette one side
// lies behind, three of nine samples at least; on a concave crease both sides come nearer, by TOLERANCE at most. One or
// two samples are too few: an edge hidden just inside an outline would show through where a corner of its neighbourhood
// reaches past the outline.
bool visible(vec2 at, float depth) {
    ivec2 last = ivec2(viewport) - 1;
    ivec2 center = clamp(ivec2(at), ivec2(0), last);
    float line = view_depth(depth);
    float nearest = line - TOLERANCE * pixel_size * (eye.w > 0.0 ? line : 1.0) - 1e-5 * line;
    int behind = 0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float scene = texelFetch(depth_buffer, clamp(center + ivec2(x, y), ivec2(0), last), 0).r;
            behind += int(scene <= 0.0 || view_depth(scene) >= nearest);
        }
    return behind >= 3;
}

void main() {
    vec2 start = segment.xy;
    vec2 along = segment.zw - start;
    vec2 offset = gl_FragCoord.xy - start;
    float t = clamp(dot(offset, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    float away = distance(offset, t * along);
    // A box filter one pixel wide; a line thinner than a pixel keeps its width as opacity.
    float coverage = clamp(half_width - away + 0.5, 0.0, min(1.0, 2.0 * half_width));
    if (coverage <= 0.0) discard;
    if (!visible(start + t * along, mix(depths.x, depths.y, t))) discard;
    out_line = vec4(color, 1.0) * coverage;
}
