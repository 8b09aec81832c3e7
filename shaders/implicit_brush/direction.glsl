// Theta's direction, of either sign.
vec2 direction_of(vec2 twice) {
    float size = length(twice);
    if (size < 1e-4) return vec2(0.0);
    float c = twice.x / size;
    // The half angle by the form that does not cancel.
    float a = sqrt(0.5 + 0.5 * abs(c)), b = 0.5 * twice.y / (size * a);
    return c >= 0.0 ? vec2(a, b) : vec2(b, a);
}
