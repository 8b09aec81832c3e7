// What pixels stamp, and what a stamp adds to a pixel.
// Defines: SAME_PLACE where all have one place, radius and angle; SAME_COLOR where all have one colour; and those of
// footprint.glsl.
#include "implicit_brush/footprint.glsl"

layout(binding = 0) uniform sampler2D stamp_places; // middle from the pixel's centre x, y; radius: px; angle
layout(binding = 1) uniform sampler2D stamp_inks;   // colour times weight; weight

uniform vec4 same_place;
uniform float nominal_radius;
uniform float largest_radius;

// Sums of one colour are those of its opacity.
#ifdef SAME_COLOR
#define SUM float
#else
#define SUM vec4
#endif

struct Stamp {
    vec2 shift; // px
    float radius;
    vec2 turn;
    SUM ink;
};

vec4 place_of(ivec2 pixel) {
#ifdef SAME_PLACE
    return same_place;
#else
    return texelFetch(stamp_places, pixel, 0);
#endif
}

// Whether a pixel stamps at all: what is no number does not.
bool is_stamp(vec4 place, float weight) {
    return weight > 0.0 && place.z > 1e-3 && dot(abs(place), vec4(1.0)) < 1e6;
}

// A stamp of half the nominal radius counts twice: so a line, which is a row of them, is as dark wherever it is wide
// beside its weights, and fades with its width below that.
Stamp make_stamp(vec4 place, vec4 ink) {
    float radius = min(place.z, largest_radius);
    float heavier = nominal_radius / radius;
#ifdef ROUND
    vec2 turn = vec2(1.0, 0.0);
#else
    vec2 turn = vec2(cos(place.w), sin(place.w));
#endif
#ifdef SAME_COLOR
    return Stamp(place.xy, radius, turn, ink.a * heavier);
#else
    return Stamp(place.xy, radius, turn, ink * heavier);
#endif
}

// What a stamp of `pixel` adds to pixel `here` (equation 3, times a pixel's area of 1 px^2).
SUM stamped(Stamp stamp, ivec2 pixel, ivec2 here) {
    vec2 place = vec2(here - pixel) - stamp.shift;
#if TIP == 5 && !defined(SAME_COLOR)
    vec4 tip = bitmap_footprint(place, stamp.turn, stamp.radius);
    return tip_colored ? stamp.ink.a * tip : stamp.ink * tip.a;
#elif TIP == 5
    return stamp.ink * bitmap_footprint(place, stamp.turn, stamp.radius).a;
#else
    return stamp.ink * footprint(place, stamp.turn, stamp.radius);
#endif
}
