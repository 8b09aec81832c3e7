// The polynomial f = a0 x^2 + 2 a1 xy + a2 y^2 + a3 x + a4 y + a5 that fits the tones around a place best (section 3.1),
// of one channel. x and y are in half line widths: curvature is the change of tone over half a width, whatever that is in
// pixels.

struct Fit {
    float xx, xy, yy; // a0, a1, a2
    float x, y;       // a3, a4
    float tone;       // a5
};

#if TAPS == 2
// 5 x 5, a quarter of a width apart.
Fit fit_at(vec2 offset, float spacing) {
    Fit f = Fit(float(0.0), float(0.0), float(0.0), float(0.0), float(0.0), float(0.0));
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
            vec2 p = 0.5 * vec2(i, j);
            float t = tone_at(offset + spacing * p);
            f.xx += (p.x * p.x - 0.5) * t;
            f.yy += (p.y * p.y - 0.5) * t;
            f.xy += p.x * p.y * t;
            f.x += p.x * t;
            f.y += p.y * t;
            f.tone += t;
        }
    f.xx /= 4.375;
    f.yy /= 4.375;
    f.xy /= 12.5;
    f.x /= 12.5;
    f.y /= 12.5;
    f.tone = f.tone / 25.0 - 0.5 * (f.xx + f.yy);
    return f;
}
#else
// 3 x 3, half a width apart, weighted 1, MIDDLE, 1 along each axis: with 4 the middle counts as a Gaussian has it, which
// makes the fit more alike in all directions than with 1, the paper's.
#if TAPS == 1
#define MIDDLE 4.0
#else
#define MIDDLE 1.0
#endif

Fit fit_taps(float t[9]) {
    const float row = 1.0 / (2.0 * (2.0 + MIDDLE));
    Fit f;
    float left = t[0] + MIDDLE * t[3] + t[6], right = t[2] + MIDDLE * t[5] + t[8];
    float low = t[0] + MIDDLE * t[1] + t[2], high = t[6] + MIDDLE * t[7] + t[8];
    float middle_x = t[1] + MIDDLE * t[4] + t[7], middle_y = t[3] + MIDDLE * t[4] + t[5];
    f.xx = (left + right - 2.0 * middle_x) * row;
    f.yy = (low + high - 2.0 * middle_y) * row;
    f.x = (right - left) * row;
    f.y = (high - low) * row;
    f.xy = (t[0] + t[8] - t[2] - t[6]) * 0.125;
    f.tone = (left + right + MIDDLE * middle_x) * (4.0 * row * row) - (f.xx + f.yy) * (4.0 * row);
    return f;
}

Fit fit_at(vec2 offset, float spacing) {
    float t[9];
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) t[3 * j + i] = tone_at(offset + spacing * vec2(i - 1, j - 1));
    return fit_taps(t);
}
#endif

#if defined(WHOLE_SPACING) && TAPS != 2
// At a pixel's own middle, where taps are texels: unfiltered, and both channels at once.
void fit_here(ivec2 pixel, out Fit diffuse, out Fit specular) {
    float first[9], second[9];
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            vec2 t = texel_at(pixel + WHOLE_SPACING * ivec2(i - 1, j - 1));
            first[3 * j + i] = t.r;
            second[3 * j + i] = t.g;
        }
    diffuse = fit_taps(first);
    specular = fit_taps(second);
}
#endif

// The eigenvalue of M of larger magnitude: half the principal curvature.
float curvature_of(Fit f) {
    float mean = 0.5 * (f.xx + f.yy), difference = 0.5 * (f.xx - f.yy);
    float root = sqrt(difference * difference + f.xy * f.xy);
    return mean < 0.0 ? mean - root : mean + root;
}
