#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

/// Polynomials of two variables fitted to weighted points by least squares, through moments: the normal equations hold
/// sums of w x^i y^j only, of which there are fewer than entries. All on the stack, in double.
namespace hachure::geometry {

/// The points of a patch, z over (x, y). Lengths are in units of the patch, so that |x| and |y| are at most 1.
struct PatchPoints {
    static constexpr std::size_t most = 1280;
    static constexpr std::size_t lanes = 2;

    std::size_t count = 0; ///< a multiple of `lanes`; points without a weight fill it up
    alignas(64) std::array<double, most> x, y, z, weight;
};

/// Where the term x^i y^j stands among those of total degree <= n, and how many there are.
[[nodiscard]] constexpr std::size_t term(std::size_t n, std::size_t i, std::size_t j) {
    return j * (n + 1) - j * (j - 1) / 2 + i;
}
[[nodiscard]] constexpr std::size_t term_count(std::size_t n) { return (n + 1) * (n + 2) / 2; }

/// Sums over the points: all that a fit of this degree depends on.
template <std::size_t degree> struct PatchMoments {
    std::array<double, term_count(2 * degree)> xy{}; ///< weight x^i y^j
    std::array<double, term_count(degree)> xyz{};    ///< weight x^i y^j z
    double zz = 0.0, weight = 0.0;
};

/// Room for the powers of x and y of every point.
struct PatchPowers {
    alignas(64) std::array<std::array<double, PatchPoints::most>, 9> x; ///< times the weight
    alignas(64) std::array<double, PatchPoints::most> y;
};

namespace patch_detail {

using Pair = double __attribute__((vector_size(16))); // two at once on any machine
static_assert(sizeof(Pair) == PatchPoints::lanes * sizeof(double));

inline Pair load_pair(const double* from) {
    Pair value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

inline void store_pair(double* to, const Pair& value) { std::memcpy(to, &value, sizeof value); }

/// The sums with y^j; leaves y^(j + 1) behind. They stay in registers over the loop.
template <std::size_t degree, std::size_t j>
void add_row(const PatchPoints& points, PatchPowers& powers, PatchMoments<degree>& sums) {
    constexpr std::size_t top = 2 * degree - j, top_z = j <= degree ? degree - j + 1 : 0;
    Pair xy[top + 1] = {}, xyz[top_z + 1] = {};
    for (std::size_t p = 0; p < points.count; p += PatchPoints::lanes) {
        const Pair y = load_pair(&powers.y[p]), yz = y * load_pair(&points.z[p]);
        for (std::size_t i = 0; i <= top; ++i) xy[i] += load_pair(&powers.x[i][p]) * y;
        for (std::size_t i = 0; i < top_z; ++i) xyz[i] += load_pair(&powers.x[i][p]) * yz;
        store_pair(&powers.y[p], y * load_pair(&points.y[p]));
    }
    for (std::size_t i = 0; i <= top; ++i) sums.xy[term(2 * degree, i, j)] = xy[i][0] + xy[i][1];
    for (std::size_t i = 0; i < top_z; ++i) sums.xyz[term(degree, i, j)] = xyz[i][0] + xyz[i][1];
}

/// Exponents of the unknowns: those that nobody asks for first, then x, y, xx, xy, yy, which back substitution reaches
/// at once.
template <std::size_t degree> constexpr auto unknowns() {
    std::array<std::pair<std::size_t, std::size_t>, term_count(degree)> result{};
    std::size_t k = 0;
    for (std::size_t d = degree; d > 2; --d)
        for (std::size_t i = 0; i <= d; ++i) result[k++] = {i, d - i};
    for (const auto& exponents : {std::pair{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}})
        result[k++] = {static_cast<std::size_t>(exponents.first), static_cast<std::size_t>(exponents.second)};
    return result;
}

} // namespace patch_detail

template <std::size_t degree>
[[nodiscard]] PatchMoments<degree> patch_moments(const PatchPoints& points, PatchPowers& powers) {
    using namespace patch_detail;
    PatchMoments<degree> sums;
    Pair zz = {}, weight = {};
    for (std::size_t p = 0; p < points.count; p += PatchPoints::lanes) {
        const Pair x = load_pair(&points.x[p]), z = load_pair(&points.z[p]);
        Pair power = load_pair(&points.weight[p]);
        weight += power;
        zz += power * z * z;
        for (std::size_t i = 0; i <= 2 * degree; ++i, power *= x) store_pair(&powers.x[i][p], power);
        store_pair(&powers.y[p], Pair{1.0, 1.0});
    }
    sums.zz = zz[0] + zz[1];
    sums.weight = weight[0] + weight[1];
    [&]<std::size_t... j>(std::index_sequence<j...>) { (add_row<degree, j>(points, powers, sums), ...); }
    (std::make_index_sequence<2 * degree + 1>{});
    return sums;
}

/// What is asked of a fit, at the origin.
struct PatchFit {
    double x, y, xx, xy, yy; ///< derivatives of z, not coefficients
    double noise;            ///< variance of the points about the polynomial; 0 where too few are left to tell
    double gain; ///< the expected (error of xx)^2 + 2 (of xy)^2 + (of yy)^2, over the variance of the points
};

/// False when the points do not determine the polynomial. Cholesky: L L^T = A, L y = b, then L^T c = y for the last
/// five unknowns alone. The last three by three of L hold the covariance of the second derivatives.
template <std::size_t degree> [[nodiscard]] bool fit_patch(const PatchMoments<degree>& sums, PatchFit& fit) {
    constexpr std::size_t n = term_count(degree);
    static constexpr auto unknown = patch_detail::unknowns<degree>();
    double l[n][n], y[n], explained = 0.0; // the diagonal of l is inverted
    for (std::size_t r = 0; r < n; ++r) {
        const auto [i, j] = unknown[r];
        for (std::size_t c = 0; c <= r; ++c)
            l[r][c] = sums.xy[term(2 * degree, i + unknown[c].first, j + unknown[c].second)];
        y[r] = sums.xyz[term(degree, i, j)];
    }
    for (std::size_t c = 0; c < n; ++c) {
        double pivot = l[c][c];
        for (std::size_t k = 0; k < c; ++k) pivot -= l[c][k] * l[c][k];
        if (!(pivot > 1e-11 * l[c][c])) return false;
        const double inverse = l[c][c] = 1.0 / std::sqrt(pivot);
        for (std::size_t k = 0; k < c; ++k) y[c] -= l[c][k] * y[k];
        y[c] *= inverse;
        explained += y[c] * y[c];
        for (std::size_t r = c + 1; r < n; ++r) {
            for (std::size_t k = 0; k < c; ++k) l[r][c] -= l[r][k] * l[c][k];
            l[r][c] *= inverse;
        }
    }
    for (std::size_t r = n; r-- > n - 5;) {
        for (std::size_t k = r + 1; k < n; ++k) y[r] -= l[k][r] * y[k];
        y[r] *= l[r][r];
    }
    const double a = l[n - 3][n - 3], b = l[n - 2][n - 2], c = l[n - 1][n - 1], ab = -l[n - 2][n - 3] * a * b,
                 bc = -l[n - 1][n - 2] * b * c, ac = -(l[n - 1][n - 3] * a + l[n - 1][n - 2] * ab) * c;
    const double freedom = sums.weight - static_cast<double>(n);
    fit = {.x = y[n - 5],
           .y = y[n - 4],
           .xx = 2.0 * y[n - 3],
           .xy = y[n - 2],
           .yy = 2.0 * y[n - 1],
           .noise = freedom >= 1.0 ? std::max(0.0, sums.zz - explained) / freedom : 0.0,
           .gain = 4.0 * (a * a + ab * ab + ac * ac) + 2.0 * (b * b + bc * bc) + 4.0 * c * c};
    return true;
}

} // namespace hachure::geometry
