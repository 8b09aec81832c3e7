#version 450 core
// Noise for brushes (Vergne et al. 2011, end of section 4.1); systems/implicit_brush/brush_noise_job.h sets it up.
#include "implicit_brush/noise.glsl"

// So many of a field's cells lie between changes of its sign, in a plane through a solid one as in a plane one.
const float cells_per_grain = 1.6;

#define SOLID 0
#define ADVECTED 1
#define SCREEN 2

#ifdef PLACES
layout(binding = 0) uniform sampler2D places;   // place on the surface at rest, in radii of it; radii per pixel
layout(binding = 1) uniform usampler2D objects; // seed of the object, metres in a radius (a float's bits)
#endif
#if GRAIN == ADVECTED
layout(binding = 2) uniform sampler2D past_0; // place on the screen when noise was made, how much farther, weight
layout(binding = 3) uniform sampler2D past_1;
#endif

uniform float size;            // of a grain: pixels, or with WORLD_SIZE metres
uniform float reference_pixel; // radii per pixel where an object fills the picture's height
uniform float flatness;
uniform uint seed;

layout(location = 0) out vec4 noise;

// What is not on a surface has no distance: grains in metres are there as large as those of the default brush.
const float nowhere_size = 12.0;

// Logarithm of the size of a field's cells.
float cells(float grain) { return log2(max(grain, 1e-20) / cells_per_grain); }

// Pixels of a grain on the screen here.
float screen_size(ivec2 pixel) {
#ifndef WORLD_SIZE
    return size;
#elif defined(PLACES)
    float pixel_radii = texelFetch(places, pixel, 0).w;
    if (pixel_radii <= 0.0) return nowhere_size;
    return size / (pixel_radii * uintBitsToFloat(texelFetch(objects, pixel, 0).y));
#else
    return nowhere_size;
#endif
}

vec4 screen_field(ivec2 pixel) {
    return normal_field(gl_FragCoord.xy, cells(max(screen_size(pixel), 1.0)), seed);
}

#if GRAIN == SOLID
vec4 solid_field(ivec2 pixel) {
    vec4 place = texelFetch(places, pixel, 0);
    if (place.w <= 0.0) return screen_field(pixel);
    uvec2 object = texelFetch(objects, pixel, 0).xy;
#ifdef WORLD_SIZE
    float level = cells(size / uintBitsToFloat(object.y));
#else
    // Between grains of one size on the screen, and grains of one size on the surface.
    float level = cells(size) + mix(log2(reference_pixel), log2(place.w), flatness);
#endif
    return normal_field(place.xyz, level, seed ^ object.x);
}
#endif

#if GRAIN == ADVECTED
vec4 past_field(vec4 past, float grain, uint phase) {
    // Grains keep their size while what they are on comes and goes: those made far off are made finer.
    return past.w * normal_field(past.xy, cells(grain) + flatness * past.z, seed + phase);
}

vec4 advected_field(ivec2 pixel) {
    vec4 past[2] = vec4[2](texelFetch(past_0, pixel, 0), texelFetch(past_1, pixel, 0));
    float power = past[0].w * past[0].w + past[1].w * past[1].w;
    if (power <= 0.0) return screen_field(pixel);
    float grain = max(screen_size(pixel), 1.0);
    vec4 sum = vec4(0.0);
    if (past[0].w > 0.0) sum += past_field(past[0], grain, 0x9e3779b9u);
    if (past[1].w > 0.0) sum += past_field(past[1], grain, 0x3c6ef372u);
    return sum * inversesqrt(power);
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#if GRAIN == SOLID
    noise = evened(solid_field(pixel));
#elif GRAIN == ADVECTED
    noise = evened(advected_field(pixel));
#else
    noise = evened(screen_field(pixel));
#endif
}
