#pragma once

#include <hachure/tests/support/line_images.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace hachure::test {

/// Sections 3.1 and 3.2 of Lee 2007 in double precision, written from the paper: what the shaders are compared with.
struct RidgeSearch {
    double width = 4.0;         ///< w, pixels
    double beta = 0.2;          ///< part of the distance that a step goes
    int iterations = 5;         ///< fits on the way
    int polish = 1;             ///< further whole steps, for the position
    double gain = 1.15;         ///< of whole steps: a fit falls short of a blurred bar by a sixth
    int side = 3;               ///< samples of a side of the grid: 3 or 5
    double middle_weight = 4.0; ///< weight of rows and columns through the middle; those beside have 1
    double guard = 1e-9;        ///< |c| below which there is no line, before anything is divided
    double least_fit = 3.0;     ///< least width that is blurred and fitted for, pixels

    [[nodiscard]] double fitted_width() const { return std::max(width, least_fit); }
    [[nodiscard]] double deviation() const { return 0.5 * fitted_width(); } ///< of the Gaussian
};

/// The quadratic a0 x^2 + 2 a1 xy + a2 y^2 + a3 x + a4 y + a5 that is nearest to samples around the origin.
struct Quadratic {
    std::array<double, 6> a{};
};

/// The matrix that makes coefficients of samples, (X^T W X)^-1 X^T W.
class QuadraticFit {
public:
    explicit QuadraticFit(const RidgeSearch& search) {
        const int reach = search.side / 2;
        const double step = 0.5 * search.fitted_width() / reach;
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                places_.emplace_back(i * step, j * step);
                weights_.push_back((i == 0 ? search.middle_weight : 1.0) * (j == 0 ? search.middle_weight : 1.0));
            }
        solve();
    }

    template <class Tone> Quadratic fit(const Tone& tone, glm::dvec2 around) const {
        Quadratic q;
        for (std::size_t n = 0; n < places_.size(); ++n) {
            const double t = tone(around + places_[n]);
            for (std::size_t k = 0; k < 6; ++k) q.a[k] += rows_[n][k] * t;
        }
        return q;
    }

private:
    using Row = std::array<double, 6>;

    static Row monomials(glm::dvec2 p) { return {p.x * p.x, 2.0 * p.x * p.y, p.y * p.y, p.x, p.y, 1.0}; }

    /// Gauss-Jordan elimination of the normal equations, with a column for each sample.
    void solve() {
        const std::size_t n = places_.size();
        std::vector<std::vector<double>> m(6, std::vector<double>(6 + n));
        for (std::size_t s = 0; s < n; ++s) {
            const Row row = monomials(places_[s]);
            for (std::size_t i = 0; i < 6; ++i) {
                for (std::size_t j = 0; j < 6; ++j) m[i][j] += weights_[s] * row[i] * row[j];
                m[i][6 + s] = weights_[s] * row[i];
            }
        }
        for (std::size_t p = 0; p < 6; ++p) {
            std::size_t best = p;
            for (std::size_t i = p + 1; i < 6; ++i)
                if (std::abs(m[i][p]) > std::abs(m[best][p])) best = i;
            std::swap(m[p], m[best]);
            const double pivot = m[p][p];
            for (double& v : m[p]) v /= pivot;
            for (std::size_t i = 0; i < 6; ++i) {
                if (i == p) continue;
                const double factor = m[i][p];
                for (std::size_t j = 0; j < 6 + n; ++j) m[i][j] -= factor * m[p][j];
            }
        }
        rows_.resize(n);
        for (std::size_t s = 0; s < n; ++s)
            for (std::size_t k = 0; k < 6; ++k) rows_[s][k] = m[k][6 + s];
    }

    std::vector<glm::dvec2> places_;
    std::vector<double> weights_;
    std::vector<Row> rows_;
};

/// The eigenvalue of M of larger magnitude, and its direction: across the line.
inline double strongest_eigenvalue(const Quadratic& q, glm::dvec2& direction) {
    const double mean = 0.5 * (q.a[0] + q.a[2]), half = 0.5 * (q.a[0] - q.a[2]), root = std::hypot(half, q.a[1]);
    const double angle = 0.5 * std::atan2(q.a[1], half); // of the larger eigenvalue's direction
    direction =
        mean >= 0.0 ? glm::dvec2(std::cos(angle), std::sin(angle)) : glm::dvec2(-std::sin(angle), std::cos(angle));
    return mean >= 0.0 ? mean + root : mean - root;
}

/// What a pixel finds.
struct FoundLine {
    bool found = false;     ///< |c| stayed above the guard while the search went on
    bool settled = false;   ///< whole steps came to rest: a line, and no edge
    glm::dvec2 offset{0.0}; ///< from the pixel's centre to the line
    double rim = 0.0;       ///< the distance that half a width is compared with: of a line, or the path to an edge
    double curvature = 0.0; ///< signed c: change of tone over half a width

    [[nodiscard]] bool drawn(double width) const { return found && rim <= 0.5 * width; }
};

/// One fit: where the line is from the fitted place, in its direction across; false where there is none.
template <class Tone> class LineFit {
public:
    LineFit(const Tone& tone, const RidgeSearch& search) : tone_(tone), search_(search), fit_(search) {}

    bool at(glm::dvec2 place) {
        const Quadratic q = fit_.fit(tone_, place);
        glm::dvec2 across;
        const double eigenvalue = strongest_eigenvalue(q, across), half = 0.5 * search_.fitted_width();
        curvature = half * half * eigenvalue;
        if (!(std::abs(curvature) >= search_.guard)) return false;
        step = -glm::dot(glm::dvec2(q.a[3], q.a[4]), across) / (2.0 * eigenvalue) * across;
        return true;
    }

    double curvature = 0.0;
    glm::dvec2 step{0.0};

private:
    const Tone& tone_;
    const RidgeSearch& search_;
    QuadraticFit fit_;
};

/// The search of one pixel: steps of beta of the way, then whole ones. Where these come to rest it is a line, and
/// belongs to pixels up to half a width from it. Where they don't it is an edge of tones, and section 3.2 counts the
/// path.
template <class Tone> FoundLine search_line(LineFit<Tone>& fit, const RidgeSearch& search, glm::dvec2 pixel) {
    FoundLine result;
    glm::dvec2 place = pixel;
    for (int k = 0; k < search.iterations; ++k) {
        if (!fit.at(place)) return result;
        result.rim += search.beta * glm::length(fit.step);
        result.curvature = fit.curvature;
        result.offset = place - pixel + search.gain * fit.step;
        place += (k + 1 < search.iterations ? search.beta : search.gain) * fit.step;
    }
    result.found = true;
    double last = glm::length(fit.step);
    for (int k = 0; k < search.polish; ++k) {
        if (!fit.at(place)) return result;
        const double next = glm::length(fit.step);
        result.settled = next <= std::max(0.25 * last, 0.02);
        last = next;
        place += search.gain * fit.step;
    }
    if (!result.settled) return result;
    result.offset = place - pixel;
    result.rim = glm::length(result.offset);
    result.curvature = fit.curvature;
    return result;
}

/// exp(-x^2 / 2 s^2) at whole pixels up to `reach` deviations, with sum 1.
inline std::vector<double> gaussian_weights(double s, double reach) {
    const int r = static_cast<int>(std::ceil(reach * s));
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -r; i <= r; ++i) sum += weights.emplace_back(std::exp(-0.5 * i * i / (s * s)));
    for (double& w : weights) w /= sum;
    return weights;
}

/// Blurred exactly: a Gaussian is the product of its rows and columns.
inline Tones blurred(const Tones& tones, double s, double reach = 5.0) {
    const std::vector<double> weights = gaussian_weights(s, reach);
    const int r = static_cast<int>(weights.size() / 2);
    Tones rows(tones.width, tones.height), result(tones.width, tones.height);
    const auto pass = [&](const Tones& from, Tones& to, int dx, int dy) {
        for (int y = 0; y < to.height; ++y)
            for (int x = 0; x < to.width; ++x) {
                double sum = 0.0;
                for (int i = -r; i <= r; ++i)
                    sum += weights[static_cast<std::size_t>(i + r)] * from.clamped(x + i * dx, y + i * dy);
                to.at(x, y) = sum;
            }
    };
    pass(tones, rows, 1, 0);
    pass(rows, result, 0, 1);
    return result;
}

/// Between the four nearest texels, as a GPU's filter does.
struct BilinearTone {
    const Tones& tones;

    double operator()(glm::dvec2 p) const {
        const double x = p.x - 0.5, y = p.y - 0.5, fx = std::floor(x), fy = std::floor(y);
        const int i = static_cast<int>(fx), j = static_cast<int>(fy);
        const double s = x - fx, t = y - fy;
        return (1.0 - t) * ((1.0 - s) * tones.clamped(i, j) + s * tones.clamped(i + 1, j)) +
               t * ((1.0 - s) * tones.clamped(i, j + 1) + s * tones.clamped(i + 1, j + 1));
    }
};

} // namespace hachure::test
