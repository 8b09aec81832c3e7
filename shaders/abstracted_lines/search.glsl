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

struct Ridge {
    bool found;
    vec2 offset;     // px, from the pixel's middle to the line's
    float curvature; // at the line, signed
    vec2 across;     // unit
};

// A fit far from a ridge overshoots: its parabola is flatter than the ridge is. No step is longer than this, in half
// widths.
const float longest_step = 1.5;

// `low`: the threshold c_l; `width` px; `first` is the fit at the pixel.
Ridge follow(vec2 here, Fit first, int channel, float width, float beta, float low) {
    float spacing = 0.5 * width;
    Ridge ridge = Ridge(false, vec2(0.0), 0.0, vec2(1.0, 0.0));
    Principal p = principal(first, channel);
    float side = sign(p.curvature);
    vec2 moved = vec2(0.0); // px
    for (int i = 1; i < ITERATIONS; ++i) {
        moved += beta * spacing * clamp(p.distance, -longest_step, longest_step) * p.across;
        if (dot(moved, moved) > (spacing + 1.0) * (spacing + 1.0)) return ridge;
        Fit f = fit_at(here + moved, spacing);
        if (side * larger_eigenvalue(f.xx[channel], f.xy[channel], f.yy[channel]) < low) return ridge;
        p = principal(f, channel);
    }
    // The paper adds up the ways; with a small beta little of the way was gone, so that what is left counts, too.
    vec2 total = moved + spacing * clamp(p.distance, -longest_step, longest_step) * p.across;
    float reach = spacing + 1.0;
    if (dot(total, total) > reach * reach) return ridge;
    // On a ridge whole steps arrive at its very middle; beside the edge of a tone there is none to arrive at.
    for (int i = 0; i < POLISH; ++i) {
        Fit f = fit_at(here + total, spacing);
        if (side * larger_eigenvalue(f.xx[channel], f.xy[channel], f.yy[channel]) < low) break;
        Principal q = principal(f, channel);
        float trust = 1.0 - smoothstep(0.25, 0.5, abs(q.distance));
        if (trust <= 0.0) break;
        total += trust * spacing * q.distance * q.across;
        p.curvature = mix(p.curvature, q.curvature, trust);
        p.across = q.across;
    }
    ridge.found = true;
    ridge.offset = total;
    ridge.curvature = p.curvature;
    ridge.across = p.across;
    return ridge;
}
