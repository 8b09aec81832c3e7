// Opacity falls from the middle part of a line to its rim, over a pixel at least; a line narrower than one is fainter.
float across_width(float away, float width, float fade) {
    float ramp = max(0.5 * fade * width, 1.0);
    float rim = 0.5 * width + 0.5 * max(1.0 - 0.5 * fade * width, 0.0);
    return clamp((rim - away) / ramp, 0.0, min(1.0, width));
}
