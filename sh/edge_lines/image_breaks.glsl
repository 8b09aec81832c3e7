// Where the picture's surfaces break off, for the passes that look for it: pixels, and what they say of each other.
#include "surface/surface_code.glsl"

const int TILE = 8;     // pixels along a side; systems/edge_lines/image_lines.h has the same
const float STEP = 3.0; // pixels that a surface has to lie behind the plane that goes on from its neighbour

layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform usampler2D codes;

uniform ivec4 area; // first and last pixel of what is looked at

ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), ivec2(viewport) - 1); }
float depth_at(ivec2 pixel) { return texelFetch(depth_buffer, inside(pixel), 0).r; }
uvec2 code_at(ivec2 pixel) { return texelFetch(codes, inside(pixel), 0).rg; }

// Whether two directions are farther apart than the angle of a cosine: dot < cosine * lengths, both sides squared with
// their signs, for roots are dear.
bool turns(vec3 a, vec3 b, float cosine) {
    float d = dot(a, b);
    return d * abs(d) < cosine * abs(cosine) * dot(a, a) * dot(b, b);
}

// view_depth() is a fraction of two linear functions of the depth; this is the lower one.
float under(float depth) { return abs(depth * clip_from_view[2][3] - clip_from_view[2][2]); }

// A plane's depth in the window is linear, so that what goes on beyond a pixel is foretold by the pixel before it. Where
// both sides foretell the other wrongly there is a step. Metres between two depths are the difference of the fractions,
// whose upper part is the determinant of both functions times the difference of the depths.
bool breaks_off(float before, float here, float there, float after) {
    float determinant = abs(clip_from_view[3][2] * clip_from_view[2][3] - clip_from_view[3][3] * clip_from_view[2][2]);
    float tolerance = STEP * pixel_size * (eye.w > 0.0 ? view_depth(max(here, there)) : 1.0);
    float foretold_there = max(2.0 * here - before, 1e-9), foretold_here = max(2.0 * there - after, 1e-9);
    return determinant * abs(there - foretold_there) > tolerance * under(there) * under(foretold_there) &&
           determinant * abs(here - foretold_here) > tolerance * under(here) * under(foretold_here);
}
