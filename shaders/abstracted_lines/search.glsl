// From a pixel to the ridge or valley of the tone image beside it (sections 3.1 and 3.2), of the channel that tone_at()
// reads.

// Across a ridge or valley, in half line widths.
struct Principal {
    float curvature; // the eigenvalue of M of larger magnitude: half the principal curvature; > 0 in a valley
    vec2 across;     // its eigenvector, unit
    float distance;  // along `across` to the middle; valid where the curvature is not 0
};

// The caller has seen that the curvature is above its threshold: nothing is divided by 0.
Principal principal(Fit f) {
    Principal p;
    p.curvature = curvature_of(f);
    // Of the two forms of the eigenvector the one that does not vanish.
    vec2 a = vec2(p.curvature - f.yy, f.xy), b = vec2(f.xy, p.curvature - f.xx);
    vec2 u = dot(a, a) > dot(b, b) ? a : b;
    float square = dot(u, u);
    p.across = square > 0.0 ? u * inversesqrt(square) : vec2(1.0, 0.0); // all directions alike: any
    p.distance = -dot(vec2(f.x, f.y), p.across) / (2.0 * p.curvature);
    return p;
}

// A fit far from a ridge overshoots: its parabola is flatter than the ridge is. No step is longer than this, in half
// widths.
const float longest_step = 1.0;
// By how much the distance that the fit shows falls along a way to the middle: taps half a width apart flatten the top of
// a blurred bar of the width that is looked for by .16, of a thin line by .23.
const float first_slope = 0.87;
#include "abstracted_lines/guard.glsl"

// A place that the search is at.
struct Place {
    vec2 offset; // px, from the pixel's middle
    Principal p;
};

// The parabola through three tones along a direction, in half widths: curvature, and distance to its middle.
vec2 parabola_along(vec2 offset, vec2 direction, float side) {
    float before = tone_at(offset - direction), at = tone_at(offset), after = tone_at(offset + direction);
    float curvature = side * (0.5 * (before + after) - at);
    return vec2(curvature, -0.25 * side * (after - before) / max(curvature, 1e-6));
}

// From the pixel to where the tone neither rises nor falls across the line: its very middle. A parabola's distance would
// fall by all of a step; how much it does is measured (the secant's slope), since lines are no parabolas: less on a bar,
// more beside a steep flank. On the way three tones along the first direction are enough; the last fit is a whole one.
// Returns how much the place can be trusted to be a middle, from 0 to 1; steps away from the edge of a tone arrive
// nowhere.
float find_middle(float spacing, float side, float guard, inout Place place) {
    // A middle up to a width away takes the pixel from edges beside it, though it is too far to be the pixel's.
    float farthest = 2.0 * spacing + 1.0;
    float slope = first_slope, distance = place.p.distance, left = abs(distance);
    vec2 direction = spacing * place.p.across;
    for (int i = 2; i < ITERATIONS; ++i) {
        float way = clamp(distance / slope, -longest_step, longest_step);
        place.offset += way * direction;
        if (dot(place.offset, place.offset) > farthest * farthest) return 0.0;
        vec2 next = parabola_along(place.offset, direction, side);
        if (next.x < guard) return 0.0;
        if (abs(way) > 0.02) slope = clamp((distance - next.y) / way, 0.75, 2.0);
        left = abs(distance);
        distance = next.y;
        if (spacing * abs(distance) < 0.01) break;
    }
    place.offset += clamp(distance / slope, -longest_step, longest_step) * direction;
    if (dot(place.offset, place.offset) > farthest * farthest) return 0.0;
    Fit f = fit_at(place.offset, spacing);
    if (side * curvature_of(f) < guard) return 0.0;
    place.p = principal(f);
    place.offset += spacing * clamp(place.p.distance / slope, -longest_step, longest_step) * place.p.across;
    // Steps that shorten quickly, or are short, arrive: beside an edge they are a quarter of a spacing long still where
    // its curvature has gone.
    float residual = abs(place.p.distance);
    return 1.0 - smoothstep(0.25, 0.5, residual / max(left, 1e-6)) * smoothstep(0.04, 0.1, residual);
}

#include "abstracted_lines/beside_edge.glsl"

struct Ridge {
    bool found;
    vec2 offset;     // px, from the pixel's middle to the line's
    float curvature; // that counts, signed
    vec2 across;     // unit
};
Ridge no_ridge() { return Ridge(false, vec2(0.0), 0.0, vec2(1.0, 0.0)); }

// `low`: the threshold c_l; `width` px, of the search; `first` is the fit at the pixel.
Ridge follow(Fit first, float width, float beta, float low) {
    float spacing = 0.5 * width, reach = spacing + 1.0;
    Ridge ridge = no_ridge();
    Place place = Place(vec2(0.0), principal(first));
    Principal start = place.p;
    float side = sign(start.curvature);
    float trust = find_middle(spacing, side, rim_part * low, place);
    ridge.offset = place.offset;
    ridge.curvature = side * place.p.curvature;
    ridge.across = place.p.across;
    if (trust < 1.0) {
        Beside beside = find_beside_edge(spacing, side, beta, start);
        ridge.offset = mix(beside.offset, ridge.offset, trust);
        ridge.curvature = mix(beside.curvature, ridge.curvature, trust);
        if (trust < 0.5) ridge.across = start.across;
    }
    ridge.found = ridge.curvature >= low && dot(ridge.offset, ridge.offset) <= reach * reach;
    ridge.curvature *= side;
    return ridge;
}
