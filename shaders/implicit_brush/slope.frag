#version 450 core
// Slopes of the relief that is seen, and where it breaks off (section 3.2.1). Define: BREAKS for the breaks themselves,
// as the gradient that occluding contours are found in; PICTURE where another renderer's depth and normals are behind.
//
// Everything is in units of a pixel's footprint, for depth and picture plane alike, so that the scale of a scene
// changes nothing: a slope is pixels of relief per pixel.
#include "common/view.glsl"

layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D normals; // world, unit
#ifdef PICTURE
layout(binding = 2) uniform sampler2D picture_depth;   // metres from the eye's plane
layout(binding = 3) uniform sampler2D picture_normals; // world
#endif

uniform float half_break; // px: a break of this depth counts half

layout(location = 0) out vec4 out_slope;

// A slope is told from a steeper one up to here: beyond it flattens out, as if a surface were stretched towards the
// eye by this, so that it ends at a limb instead of growing without bound (and a sphere stays an ellipsoid, whose
// curvatures grow towards the outline everywhere: no line inside of it).
const float steepest = 4.0;
// Of what the slopes beside a pixel explain, in px: rounding of depths and normals of small facets.
const float tolerance = 0.5;

const float limb = 2.414; // (sqrt(1) - sqrt(0)) / (sqrt(2) - sqrt(1))

struct Sight {
    float metres; // from the eye's plane; 0 where there is nothing
    vec2 slope;   // of the relief along the picture's axes, px per px, unbounded
    bool outside; // of the picture: nobody knows what is there, so nothing breaks off
};

// From the eye through a pixel's centre: to depth 1.
vec3 ray_through(vec2 pixel) {
    if (eye.w == 0.0) return vec3(0.0, 0.0, -1.0);
    vec2 ndc = 2.0 * pixel / viewport - 1.0;
    return vec3((ndc.x + clip_from_view[2][0]) / clip_from_view[0][0],
                (ndc.y + clip_from_view[2][1]) / clip_from_view[1][1], -1.0);
}

bool is_inside(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(viewport)));
}

// Metres from the eye's plane; 0 where there is nothing, which what is no number counts as.
float metres_at(ivec2 pixel) {
    if (!is_inside(pixel)) return 0.0;
    float depth = texelFetch(depth_buffer, pixel, 0).r;
    float metres = depth > 0.0 ? view_depth(depth) : 0.0;
#ifdef PICTURE
    if (!(depth > 0.0)) metres = texelFetch(picture_depth, pixel, 0).r;
#endif
    return metres > 0.0 && metres < 1e9 ? metres : 0.0;
}

vec3 normal_at(ivec2 pixel) {
    vec3 n = texelFetch(normals, pixel, 0).xyz;
#ifdef PICTURE
    if (!(texelFetch(depth_buffer, pixel, 0).r > 0.0)) n = texelFetch(picture_normals, pixel, 0).xyz;
#endif
    float square = dot(n, n);
    return square > 0.25 && square < 4.0 ? mat3(view_from_world) * (n * inversesqrt(square)) : vec3(0.0);
}

// What the relief gains between two depths, in px. In perspective a measure in which planes are exact without
// logarithms: 1 / depth is what is linear on them.
float gain_between(float from, float to) {
    float gain = (from - to) / pixel_size;
    return eye.w > 0.0 ? gain / (0.5 * (from + to)) : gain;
}

// The same over one pixel along a direction, on the plane with this slope; one that ends before explains everything.
float gain_along(float slope) {
    return eye.w > 0.0 ? slope / max(1.0 + 0.5 * pixel_size * slope, 1e-3) : slope;
}

Sight sight_at(ivec2 pixel, float metres) {
    Sight s;
    vec3 n = metres > 0.0 ? normal_at(pixel) : vec3(0.0);
    s.metres = n != vec3(0.0) ? metres : 0.0;
    s.outside = !is_inside(pixel);
    s.slope = n.xy / min(dot(n, ray_through(vec2(pixel) + 0.5)), -1e-4);
    return s;
}

float share_of(float jump) { return jump * jump / (jump * jump + half_break * half_break); }

// How much the relief breaks off between two neighbours, in [0, 1], positive where it is higher beyond. What the slopes
// on either side explain is no break, be they those of normals, which know of the bend between two pixels, or of the
// depths before and behind, which know of facets: all of a smooth surface lies between the least and the greatest of
// them (mean value theorem). Depths alone know too little of the last pixel before a limb, where a relief like sqrt(x)
// gains up to `limb` times what it did over the pixel before; slopes beyond say whether it is the same surface.
float break_between(Sight here, Sight there, int axis, float before, float after) {
    if (here.outside || there.outside) return 0.0;
    if (here.metres <= 0.0 || there.metres <= 0.0) return sign(there.metres - here.metres);
    float gain = gain_between(here.metres, there.metres);
    float by_here = gain_along(here.slope[axis]), by_there = -gain_along(-there.slope[axis]);
    if (before > 0.0) before = gain_between(before, here.metres); else before = by_here;
    if (after > 0.0) after = gain_between(there.metres, after); else after = by_there;
    if (before * by_there > before * before) before *= limb;
    if (after * by_here > after * after) after *= limb;
    float least = min(min(by_here, by_there), min(before, after));
    float most = max(max(by_here, by_there), max(before, after));
    float over = max(gain - most, 0.0) + min(gain - least, 0.0);
    return sign(over) * share_of(max(abs(over) - tolerance, 0.0));
}

// The breaks between a pixel and its neighbours before (x) and behind (y) along an axis, both along the axis' direction.
vec2 breaks_along(Sight here, ivec2 pixel, int i) {
    ivec2 axis = i == 0 ? ivec2(1, 0) : ivec2(0, 1);
    float before = metres_at(pixel - 2 * axis), after = metres_at(pixel + 2 * axis);
    Sight left = sight_at(pixel - axis, metres_at(pixel - axis)), right = sight_at(pixel + axis, metres_at(pixel + axis));
    return vec2(break_between(left, here, i, before, right.metres), break_between(here, right, i, left.metres, after));
}

// The slope that features are found in: in the frame that is turned towards the pixel's own ray, so that a sphere off
// the view's middle is as symmetrical as one in it, and bounded.
vec2 bounded_slope(vec3 n, vec3 ray) {
    vec3 toward = -normalize(ray);
    // Of the shortest rotation from the view's axis to the ray.
    vec3 x = vec3(1.0, 0.0, 0.0) - toward.x / (1.0 + toward.z) * (toward + vec3(0.0, 0.0, 1.0));
    vec3 y = vec3(0.0, 1.0, 0.0) - toward.y / (1.0 + toward.z) * (toward + vec3(0.0, 0.0, 1.0));
    vec2 across = vec2(dot(n, x), dot(n, y));
    float facing = max(dot(n, toward), 0.0);
    return -across * inversesqrt(facing * facing + dot(across, across) / (steepest * steepest));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Sight here = sight_at(pixel, metres_at(pixel));
    vec2 breaks_x = breaks_along(here, pixel, 0), breaks_y = breaks_along(here, pixel, 1);
#ifdef BREAKS
    out_slope = vec4(breaks_x.x + breaks_x.y, breaks_y.x + breaks_y.y, 0.0, 1.0);
#else
    vec2 most = max(abs(breaks_x), abs(breaks_y));
    bool there = here.metres > 0.0;
    vec2 slope = there ? bounded_slope(normal_at(pixel), ray_through(gl_FragCoord.xy)) : vec2(0.0);
    out_slope = vec4(slope, max(most.x, most.y), there ? 1.0 : 0.0);
#endif
}
