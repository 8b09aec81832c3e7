#pragma once

#include <cmath>

namespace hachure::geometry {

/// Eigenvalues of the symmetric 2x2 matrix (e, f; f, g), |k1| >= |k2|, and the unit eigenvector (x, y) of k1.
struct Principal {
    double k1, k2, x, y;
};

/// Where both eigenvalues are equal, the eigenvector is (1, 0).
[[nodiscard]] inline Principal principal(double e, double f, double g) {
    const double mean = 0.5 * (e + g), half = 0.5 * (e - g), radius = std::sqrt(half * half + f * f);
    if (!(radius > 0.0)) return {mean, mean, 1.0, 0.0};
    const double cosine = half / radius; // of twice the angle
    const double x = std::sqrt(0.5 * (1.0 + cosine)), y = std::copysign(std::sqrt(0.5 * (1.0 - cosine)), f);
    if (mean >= 0.0) return {mean + radius, mean - radius, x, y};
    return {mean - radius, mean + radius, -y, x};
}

} // namespace hachure::geometry
