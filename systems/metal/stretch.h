#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {

/// How a transform changes the shape of what it moves: the upper triangular S with positive diagonal for which
/// transform = scale * rotation * S, the rotation perhaps mirrored; the identity for moves that keep angles. Turning
/// the object leaves it as it is. The identity, too, for transforms that flatten.
[[nodiscard]] inline glm::mat3 stretch_of(const glm::mat3& transform) {
    // S^T S = transform^T transform, by Cholesky; columns as glm has them: m[column][row].
    const glm::dmat3 m(transform);
    glm::dmat3 g = glm::transpose(m) * m;
    const double scale = (g[0][0] + g[1][1] + g[2][2]) / 3.0;
    if (!(scale > 0.0) || !std::isfinite(scale)) return glm::mat3(1.0f);
    g /= scale;
    const double off = std::max({std::abs(g[1][0]), std::abs(g[2][0]), std::abs(g[2][1]), std::abs(g[0][0] - 1.0),
                                 std::abs(g[1][1] - 1.0), std::abs(g[2][2] - 1.0)});
    if (off < 1e-4) return glm::mat3(1.0f);
    glm::dmat3 s(0.0);
    const double floor = 1e-8;
    if (g[0][0] < floor) return glm::mat3(1.0f);
    s[0][0] = std::sqrt(g[0][0]);
    s[1][0] = g[1][0] / s[0][0];
    s[2][0] = g[2][0] / s[0][0];
    const double b = g[1][1] - s[1][0] * s[1][0];
    if (b < floor) return glm::mat3(1.0f);
    s[1][1] = std::sqrt(b);
    s[2][1] = (g[2][1] - s[1][0] * s[2][0]) / s[1][1];
    const double c = g[2][2] - s[2][0] * s[2][0] - s[2][1] * s[2][1];
    if (c < floor) return glm::mat3(1.0f);
    s[2][2] = std::sqrt(c);
    return glm::mat3(s);
}

/// Whether two of them are the same but for rounding.
[[nodiscard]] inline bool same_stretch(const glm::mat3& a, const glm::mat3& b) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(a[column][row] - b[column][row]) > 1e-4f) return false;
    return true;
}

} // namespace hachure
