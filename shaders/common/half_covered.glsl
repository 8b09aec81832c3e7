// Pigment on paper whose heights are spread evenly over [0, 1].

// The height that is half covered by `amount`: a ramp of width s about it, clamped to [0, 1], has the mean `amount`
// over all heights. Towards the ends the ramp is cut off by the lowest valley or the highest peak.
float half_covered(float amount, float s) {
    if (amount < 0.5 * s) return 1.0 + 0.5 * s - sqrt(2.0 * s * amount);
    if (amount > 1.0 - 0.5 * s) return sqrt(2.0 * s * (1.0 - amount)) - 0.5 * s;
    return 1.0 - amount;
}
