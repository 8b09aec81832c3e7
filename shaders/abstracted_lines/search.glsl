// From a pixel to the ridge or valley of the tone image beside it (sections 3.1 and 3.2).

// Across a ridge or valley, in half line widths.
struct Principal {
    float curvature; // the eigenvalue of M of larger magnitude: half the principal curvature; > 0 in a valley
    vec2 across;     // its eigenvector, unit
    float distance;  // along `across` to the middle; valid where the curvature is not 0
};

float larger_eigenvalue(float xx, float xy, float yy) {
    float mean = 0.5 * (xx + yy), difference = 0.5 * (xx - yy);
    float root = sqrt(difference * difference + xy * xy);
    return mean < 0.0 ? mean - root : mean + root;
}

vec2 larger_eigenvalues(Fit f) {
    vec2 mean = 0.5 * (f.xx + f.yy), difference = 0.5 * (f.xx - f.yy);
    vec2 root = sqrt(difference * difference + f.xy * f.xy);
    return mix(mean + root, mean - root, lessThan(mean, vec2(0.0)));
}

// The caller has seen that the curvature is above its threshold: nothing is divided by 0.
Principal principal(Fit f, int channel) {
    float xx = f.xx[channel], xy = f.xy[channel], yy = f.yy[channel];
    Principal p;
    p.curvature = larger_eigenvalue(xx, xy, yy);
    // Of the two forms of the eigenvector the one that does not vanish.
    vec2 a = vec2(p.curvature - yy, xy), b = vec2(xy, p.curvature - xx);
    vec2 u = dot(a, a) > dot(b, b) ? a : b;
    float square = dot(u, u);
    p.across = square > 0.0 ? u * inversesqrt(square) : vec2(1.0, 0.0); // all directions alike: any
    p.distance = -dot(vec2(f.x[channel], f.y[channel]), p.across) / (2.0 * p.curvature);
    return p;
}

// A fit far from a ridge overshoots: its parabola is flatter than the ridge is. No step is longer than this, in half
// widths.
const float longest_step = 1.0;
// By how much the distance that the fit shows falls along a way to the middle: taps half a width apart flatten the top of
// a blurred bar of the width that is looked for by .16, of a thin line by .23.
const float first_slope = 0.87;
#include "abstracted_lines/guard.glsl"

float curvature_of(Fit f, int channel) { return larger_eigenvalue(f.xx[channel], f.xy[channel], f.yy[channel]); }

// A place that the search is at.
struct Place {
    vec2 offset; // px, from the pixel's middle
    Principal p;
};

// From the pixel to where the tone neither rises nor falls across the line: its very middle. A parabola's distance would
// fall by all of a step; how much it does is measured (the secant's slope), since lines are no parabolas: less on a bar,
// more beside a steep flank. Returns how much the place can be trusted to be a middle, from 0 to 1; steps away from the
// edge of a tone arrive nowhere.
float find_middle(vec2 here, int channel, float spacing, float side, float guard, inout Place place) {
    float slope = first_slope, left = abs(place.p.distance), trust = 0.0;
    for (int i = 1; i < ITERATIONS; ++i) {
        float way = clamp(place.p.distance / slope, -longest_step, longest_step);
        place.offset += spacing * way * place.p.across;
        if (dot(place.offset, place.offset) > 4.0 * (spacing + 1.0) * (spacing + 1.0)) return 0.0;
        Fit f = fit_at(here + place.offset, spacing);
        if (side * curvature_of(f, channel) < guard) return 0.0;
        Principal next = principal(f, channel);
        if (dot(next.across, place.p.across) < 0.0) {
            next.across = -next.across;
            next.distance = -next.distance;
        }
        if (abs(way) > 0.02) slope = clamp((place.p.distance - next.distance) / way, 0.75, 2.0);
        place.p = next;
        float residual = abs(next.distance);
        // Steps that shorten quickly, or are short, arrive: beside an edge they are a quarter of a spacing long still
        // where its curvature has gone.
        trust = 1.0 - smoothstep(0.25, 0.5, residual / max(left, 1e-6)) * smoothstep(0.04, 0.1, residual);
        if (spacing * residual < 0.01) break;
        left = residual;
    }
    place.offset += spacing * clamp(place.p.distance / slope, -longest_step, longest_step) * place.p.across;
    return trust;
}

// To the middle of the line beside the edge of a tone: half a spacing beyond where the curvature along `across` is
// largest, which is a deviation of the blur from the edge. All pixels across a line come to the same place, which keeps
// its outline smooth, and none of them lies where the curvature turns over.
void find_beside_edge(vec2 here, int channel, float spacing, float side, inout Place place) {
    vec2 step = 0.5 * spacing * place.p.across;
    float at = side * place.p.curvature;
    for (int i = 0; i < 3; ++i) {
        float before = side * curvature_of(fit_at(here + place.offset - step, spacing), channel);
        float after = side * curvature_of(fit_at(here + place.offset + step, spacing), channel);
        float bend = before + after - 2.0 * at;
        float way = bend < 0.0 ? clamp(0.5 * (before - after) / bend, -2.0, 2.0) : 2.0 * sign(after - before);
        place.offset += way * step;
        Fit f = fit_at(here + place.offset, spacing);
        at = side * curvature_of(f, channel);
        if (at <= 0.0) return;
        place.p = principal(f, channel);
    }
    place.offset += 0.5 * spacing * clamp(2.0 * place.p.distance, -1.0, 1.0) * place.p.across;
}

// The paper's search (section 3.2): steps of a part beta of the distance to the ridge that the fit shows. Near a ridge
// they end at it; from an edge they lead away, and the curvature that is left tells strong edges from weak ones.
// Returns it, or 0 where the way, added up, is longer than half the line's width; without a jump.
float curvature_after_walk(vec2 here, int channel, float spacing, float side, float beta, Place place) {
    float way = 0.0, curvature = side * place.p.curvature;
    for (int i = 1; i < ITERATIONS; ++i) {
        float step = beta * spacing * clamp(place.p.distance, -2.0, 2.0);
        way += abs(step);
        place.offset += step * place.p.across;
        if (way > 1.25 * spacing) return 0.0;
        Fit f = fit_at(here + place.offset, spacing);
        curvature = side * curvature_of(f, channel);
        if (curvature <= 1e-6) return 0.0;
        place.p = principal(f, channel);
    }
    return curvature * (1.0 - smoothstep(spacing, 1.25 * spacing, way));
}

struct Ridge {
    bool found;
    vec2 offset;     // px, from the pixel's middle to the line's
    float curvature; // that counts, signed
    vec2 across;     // unit
};
Ridge no_ridge() { return Ridge(false, vec2(0.0), 0.0, vec2(1.0, 0.0)); }

// `low`: the threshold c_l; `width` px, of the search; `first` is the fit at the pixel.
Ridge follow(vec2 here, Fit first, int channel, float width, float beta, float low) {
    float spacing = 0.5 * width, reach = spacing + 1.0;
    float guard = rim_part * low;
    Ridge ridge = no_ridge();
    Place start = Place(vec2(0.0), principal(first, channel));
    float side = sign(start.p.curvature);
    Place place = start;
    float trust = find_middle(here, channel, spacing, side, guard, place);
    ridge.offset = place.offset;
    ridge.curvature = side * place.p.curvature;
    ridge.across = place.p.across;
    if (trust < 1.0) {
        find_beside_edge(here, channel, spacing, side, start);
        if (dot(start.offset, start.offset) > reach * reach) return ridge;
        float left = curvature_after_walk(here, channel, spacing, side, beta, start);
        ridge.offset = mix(start.offset, ridge.offset, trust);
        ridge.curvature = mix(left, ridge.curvature, trust);
        ridge.across = trust > 0.5 ? ridge.across : start.p.across;
    }
    ridge.found = ridge.curvature >= low && dot(ridge.offset, ridge.offset) <= reach * reach;
    ridge.curvature *= side;
    return ridge;
}
