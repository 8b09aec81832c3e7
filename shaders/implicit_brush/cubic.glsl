// The cubic that fits samples of a profile best (section 3.2.3), a u^3 + b u^2 + c u + d with u from -1 to 1 over the
// window. Define: TAPS, the samples on either side, k.
struct Cubic {
    float a, b, c, d;
    float explained; // of the samples' variance, in [0, 1]
};

// Sums of powers of u over the samples, of which the normal equations are made; even and odd powers don't mix.
const float K = float(TAPS), COUNT = 2.0 * K + 1.0;
const float M2 = COUNT * (K + 1.0) / (3.0 * K);
const float M4 = M2 * (3.0 * K * K + 3.0 * K - 1.0) / (5.0 * K * K);
const float M6 = M2 * (3.0 * K * K * K * K + 6.0 * K * K * K - 3.0 * K + 1.0) / (7.0 * K * K * K * K);

// `s`: sums of h, u h, u^2 h and u^3 h; `squares`: of h^2.
Cubic fit_cubic(vec4 s, float squares) {
    const float even = 1.0 / (COUNT * M4 - M2 * M2), odd = 1.0 / (M2 * M6 - M4 * M4);
    Cubic p = Cubic(odd * (M2 * s.w - M4 * s.y), even * (COUNT * s.z - M2 * s.x), odd * (M6 * s.y - M4 * s.w),
                    even * (M4 * s.x - M2 * s.z), 0.0);
    float variance = squares - s.x * s.x / COUNT, left = squares - dot(vec4(p.d, p.c, p.b, p.a), s);
    p.explained = 1.0 - clamp(left / max(variance, 1e-12), 0.0, 1.0);
    return p;
}

float value(Cubic p, float u) { return ((p.a * u + p.b) * u + p.c) * u + p.d; }

// Where the cubic has its maximum, and how far it falls from there over the window by its second derivative; x is
// outside of [-1, 1] where it has none. Of the two extrema t = (-b +- sqrt(b^2 - 3ac)) / 3a the maximum is always
// c / (sqrt(b^2 - 3ac) - b), which survives a = 0; there 6at + 2b = -2 sqrt(b^2 - 3ac).
vec2 maximum(Cubic p) {
    float fall = sqrt(max(p.b * p.b - 3.0 * p.a * p.c, 0.0));
    // What falls by less than the rounding of heights is level.
    if (!(fall > 2e-3 * abs(p.d) + 1e-6)) return vec2(2.0, 0.0);
    float below = fall - p.b;
    float t = abs(p.c) < 1.5 * below ? p.c / below : 2.0;
    return vec2(t, fall);
}
