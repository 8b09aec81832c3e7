// Fields of four independent channels, each evenly distributed over [-1, 1] at every place.
//
// A field is a sum of octaves of lattice noise, as in Dynamic Solid Textures (Benard et al. 2009): octave i has cells
// of 2^i units, and which octaves count follows from the size of grains wanted, so that a field can be looked at from
// any distance and octaves only fade in and out. Unlike there, each octave is a noise of its own, and the variances of
// the octaves, not their amplitudes, add up to one: a normal distribution stays one at every distance and every place,
// and its distribution function makes it even.

// PCG4D (Jarzynski and Olano 2020): four random words of four.
uvec4 pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Four values of mean 0 and variance 1, and with a few of them added up close to normal: each the sum of two bytes.
vec4 random_normal(uint place) {
    // lowbias32 (Wellons 2018), and half a round more for the second word.
    place = (place ^ (place >> 16u)) * 0x7feb352du;
    place = (place ^ (place >> 15u)) * 0x846ca68bu;
    place ^= place >> 16u;
    uint other = (place ^ 0x5bd1e995u) * 0x2c1b3c6du;
    uvec2 word = uvec2(place, other ^ (other >> 15u));
    uvec4 sum = uvec4(word & 0xffu, (word >> 16u) & 0xffu) + uvec4((word >> 8u) & 0xffu, word >> 24u);
    return (vec4(sum) - 255.0) / 104.5108;
}

// A number for each corner of a lattice; neighbours differ by constants, which spares multiplications.
const uvec3 corner_step = uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);

vec3 smooth_step(vec3 t) { return t * t * (3.0 - 2.0 * t); }

// Noise on a lattice with cells of one unit, of variance 1 everywhere: between corners, weights w of independent values
// leave a variance of sum w^2, which is divided out.
vec4 lattice_noise(vec3 p, uint seed) {
    vec3 cell = floor(p), t = smooth_step(p - cell);
    uvec3 first = uvec3(ivec3(cell)) * corner_step;
    uint corner = first.x + first.y + first.z + seed;
    vec4 sum = vec4(0.0);
    for (uint i = 0u; i < 8u; ++i) {
        uvec3 side = uvec3(i & 1u, (i >> 1u) & 1u, i >> 2u);
        vec3 weight = mix(1.0 - t, t, vec3(side));
        uvec3 step = side * corner_step;
        sum += weight.x * weight.y * weight.z * random_normal(corner + step.x + step.y + step.z);
    }
    vec3 variance = (1.0 - t) * (1.0 - t) + t * t;
    return sum * inversesqrt(variance.x * variance.y * variance.z);
}

// The same in the plane.
vec4 lattice_noise(vec2 p, uint seed) {
    vec2 cell = floor(p), t = smooth_step(vec3(p - cell, 0.0)).xy;
    uvec2 first = uvec2(ivec2(cell)) * corner_step.xy;
    uint corner = first.x + first.y + seed;
    vec4 sum = vec4(0.0);
    for (uint i = 0u; i < 4u; ++i) {
        uvec2 side = uvec2(i & 1u, i >> 1u);
        vec2 weight = mix(1.0 - t, t, vec2(side));
        uvec2 step = side * corner_step.xy;
        sum += weight.x * weight.y * random_normal(corner + step.x + step.y);
    }
    vec2 variance = (1.0 - t) * (1.0 - t) + t * t;
    return sum * inversesqrt(variance.x * variance.y);
}

// Lattices lie askew: surfaces along an axis, and rows of pixels, are common.
const mat3 askew = mat3(0.6312515, 0.4318624, -0.6442177, 0.0655042, 0.7979741, 0.5991215, 0.7728071, -0.4203953,
                        0.4754335);
const mat2 askew_in_plane = mat2(0.8775826, 0.4794255, -0.4794255, 0.8775826);

vec4 octave_noise(vec3 p, int octave, uint seed) {
    uvec4 own = pcg4d(uvec4(uint(octave), seed, 0x50110u, 1u));
    vec3 shift = vec3(own.xyz >> 8u) / 16777216.0;
    return lattice_noise(askew * p * exp2(-float(octave)) + shift, own.w);
}

vec4 octave_noise(vec2 p, int octave, uint seed) {
    uvec4 own = pcg4d(uvec4(uint(octave), seed, 0x50110u, 2u));
    vec2 shift = vec2(own.xy >> 8u) / 16777216.0;
    return lattice_noise(askew_in_plane * p * exp2(-float(octave)) + shift, own.w);
}

// How much each of three octaves counts, the one nearest to `level` in the middle. Their squares are the quadratic
// B-spline around `level`: they add up to 1, the mean squared frequency varies by 2.5 % as octaves change (with two
// octaves it is 30 %), and an octave that comes or goes does so at a finite rate.
vec3 octave_weights(float level) {
    float off = level - floor(level + 0.5);
    return vec3(0.70710678 * (0.5 - off), sqrt(0.75 - off * off), 0.70710678 * (0.5 + off));
}

// A normal field with cells of about 2^level units.
vec4 normal_field(vec3 p, float level, uint seed) {
    level = clamp(level, -60.0, 60.0);
    vec3 weights = octave_weights(level);
    int middle = int(floor(level + 0.5));
    return weights.x * octave_noise(p, middle - 1, seed) + weights.y * octave_noise(p, middle, seed) +
           weights.z * octave_noise(p, middle + 1, seed);
}

vec4 normal_field(vec2 p, float level, uint seed) {
    level = clamp(level, -60.0, 60.0);
    vec3 weights = octave_weights(level);
    int middle = int(floor(level + 0.5));
    return weights.x * octave_noise(p, middle - 1, seed) + weights.y * octave_noise(p, middle, seed) +
           weights.z * octave_noise(p, middle + 1, seed);
}

// From a normal distribution to an even one over [-1, 1]: erf(x / sqrt(2)), to 4e-4.
vec4 evened(vec4 x) {
    x = clamp(x, -6.0, 6.0);
    return tanh(0.79788456 * (x + 0.044715 * x * x * x));
}
