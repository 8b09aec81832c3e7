#version 450 core
// Where the picture's surfaces break off between a pixel and its right and upper neighbour: the object whose line that is
// (times 2, and 1 for a crease), or 0.
#include "common/view.glsl"
#include "edge_lines/image_styles.glsl"

layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform usampler2D object_ids;

layout(location = 0) out uvec2 out_marks;

const float STEP = 3.0; // pixels that a surface has to lie behind the plane that goes on from its neighbour

float depth_at(ivec2 pixel) { return texelFetch(depth_buffer, clamp(pixel, ivec2(0), ivec2(viewport) - 1), 0).r; }

// Metres between a depth and the one that was foretold for it.
float miss(float depth, float foretold) { return abs(view_depth(depth) - view_depth(max(foretold, 1e-9))); }

// A plane's depth in the window is linear, so that what goes on beyond a pixel is foretold by the pixel before it. Where
// both sides foretell the other wrongly there is a step.
bool breaks_off(ivec2 pixel, ivec2 side, float here, float there) {
    float before = depth_at(pixel - side), after = depth_at(pixel + 2 * side);
    float nearer = max(here, there);
    float tolerance = STEP * pixel_size * (eye.w > 0.0 ? view_depth(nearer) : 1.0);
    return miss(there, 2.0 * here - before) > tolerance && miss(here, 2.0 * there - after) > tolerance;
}

// The object and kind of the line between two pixels.
uint mark(ivec2 pixel, ivec2 side) {
    ivec2 other = min(pixel + side, ivec2(viewport) - 1);
    uint a = texelFetch(object_ids, pixel, 0).r, b = texelFetch(object_ids, other, 0).r;
    if (a == 0u && b == 0u) return 0u;
    float here = depth_at(pixel), there = depth_at(other);
    // The line is the nearer one's, unless that has none.
    uint first = here >= there ? a : b, second = here >= there ? b : a;
    uint owner = has_lines(first) ? first : second;
    if (!has_lines(owner)) return 0u;
    ImageStyle style = styles[owner];
    if (style.breaks > 0.0 && (a != b || (a != 0u && breaks_off(pixel, side, here, there)))) return owner * 2u;
    if (a != b) return 0u;
    vec3 n = texelFetch(normals, pixel, 0).xyz, m = texelFetch(normals, other, 0).xyz;
    return dot(n, m) < style.crease_cosine ? owner * 2u + 1u : 0u;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    out_marks = uvec2(mark(pixel, ivec2(1, 0)), mark(pixel, ivec2(0, 1)));
}
