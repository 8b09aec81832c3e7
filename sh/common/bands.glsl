// Steps as a pixel sees them: filtered in closed form over the pixel's width, so that edges of bands are smooth, and
// many bands in one pixel are their mean.

// How much `value` changes over a pixel. A step along its gradient that is filtered with a box of this width has the
// variance of one that is filtered with the square pixel. Call it where control flow is uniform, before any discard.
float pixel_width(float value) { return max(length(vec2(dFdxFine(value), dFdyFine(value))), 1e-6); }

// The integral of clamp(u / s + 0.5, 0, 1) over u up to x.
float ramp_integral(float x, float s) {
    float y = clamp(x + 0.5 * s, 0.0, s);
    return y * y / (2.0 * s) + max(x - 0.5 * s, 0.0);
}

// A step at x = 0 that rises over `softness`, averaged over `width` > 0.
float filtered_step(float x, float width, float softness) {
    if (softness <= 0.0) return clamp(x / width + 0.5, 0.0, 1.0);
    float reach = 0.5 * (softness + width);
    x = clamp(x, -reach, reach); // keeps the difference below exact far from the step
    return clamp((ramp_integral(x + 0.5 * width, softness) - ramp_integral(x - 0.5 * width, softness)) / width, 0.0,
                 1.0);
}
