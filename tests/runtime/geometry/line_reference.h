#pragma once

#include <hachure/tests/runtime/geometry/reference.h>

#include <glm/matrix.hpp>

#include <array>
#include <complex>

/// The direction field of docs/stripes.md, computed otherwise than the code under test does it: curvature from the
/// normal curvatures of edges (least squares in every vertex's tangent plane), vectors carried by the least turn
/// between tangent planes in space, linear equations by conjugate gradients; all in double precision, without any sheet
/// or half-edge.
namespace hachure::geometry::reference {

class LineField {
public:
    std::vector<glm::dvec3> direction; ///< per vertex, unit
    std::vector<double> confidence;    ///< per vertex, in [0, 1]

    LineField(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices, double detail)
        : place_(weld(positions)), count_(positions.size()), normal_(count_, glm::dvec3(0.0)), x_(count_),
          mass_(count_, 0.0) {
        for (const glm::vec3& p : positions) position_.emplace_back(p);
        gather_edges(indices);
        for (std::size_t v = 0; v < count_; ++v) {
            const double length = glm::length(normal_[v]);
            normal_[v] = length > 0.0 ? normal_[v] / length : glm::dvec3(0.0, 1.0, 0.0);
            const glm::dvec3 least =
                std::abs(normal_[v].x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
            x_[v] = glm::normalize(least - glm::dot(least, normal_[v]) * normal_[v]);
            if (!(mass_[v] > 0.0)) mass_[v] = 1e-12;
        }
        for (Link& link : links_) link.turn = std::polar(1.0, 2.0 * carried_angle(link.from, link.to));
        solve_field(detail);
    }

private:
    using Complex = std::complex<double>;
    struct Link {
        std::uint32_t from, to;
        double weight;
        Complex turn;
    };

    void gather_edges(const std::vector<std::uint32_t>& indices) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> weights;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const std::uint32_t v[3] = {place_[indices[i]], place_[indices[i + 1]], place_[indices[i + 2]]};
            const glm::dvec3 cross = glm::cross(position_[v[1]] - position_[v[0]], position_[v[2]] - position_[v[0]]);
            const double twice = glm::length(cross);
            if (!(twice > 0.0)) continue;
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = v[(k + 1) % 3], b = v[(k + 2) % 3];
                const glm::dvec3 to_a = position_[a] - position_[v[k]], to_b = position_[b] - position_[v[k]];
                // Angle-weighted normals.
                normal_[v[k]] += cross / twice * std::atan2(twice, glm::dot(to_a, to_b));
                mass_[v[k]] += twice / 6.0;
                weights[{std::min(a, b), std::max(a, b)}] += 0.5 * glm::dot(to_a, to_b) / twice;
            }
        }
        for (const auto& [ends, weight] : weights) {
            const double w = std::clamp(weight, 0.01, 100.0);
            links_.push_back({ends.first, ends.second, w, 1.0});
        }
    }

    [[nodiscard]] glm::dvec3 y(std::size_t v) const { return glm::cross(normal_[v], x_[v]); }

    /// By which angle x of one vertex turns against that of another when it is carried there.
    [[nodiscard]] double carried_angle(std::uint32_t from, std::uint32_t to) const {
        const glm::dvec3 axis = glm::cross(normal_[from], normal_[to]);
        const double c = glm::dot(normal_[from], normal_[to]);
        const glm::dvec3 x = x_[from];
        const glm::dvec3 carried =
            c > -0.999 ? c * x + glm::cross(axis, x) + axis * (glm::dot(axis, x) / (1.0 + c)) : x;
        return std::atan2(glm::dot(carried, y(to)), glm::dot(carried, x_[to]));
    }

    /// mean and deviator from the normal curvature of every edge at its ends: mean + Re(deviator exp(-2ia)).
    void raw_curvature(std::vector<Complex>& mean, std::vector<Complex>& deviator) const {
        std::vector<std::array<double, 9>> sums(count_, std::array<double, 9>{});
        const auto add = [&](std::uint32_t v, std::uint32_t other) {
            const glm::dvec3 d = position_[other] - position_[v];
            const double k = -2.0 * glm::dot(d, normal_[v]) / glm::dot(d, d);
            const double a = std::atan2(glm::dot(d, y(v)), glm::dot(d, x_[v])), c = std::cos(2.0 * a),
                         s = std::sin(2.0 * a);
            const double row[3] = {1.0, c, s}, weight = glm::dot(d, d) / mass_[v]; // short edges tell little
            std::array<double, 9>& sum = sums[v];
            int at = 0;
            for (int i = 0; i < 3; ++i)
                for (int j = i; j < 3; ++j) sum[static_cast<std::size_t>(at++)] += weight * row[i] * row[j];
            for (int i = 0; i < 3; ++i) sum[static_cast<std::size_t>(6 + i)] += weight * row[i] * k;
        };
        for (const Link& link : links_) {
            add(link.from, link.to);
            add(link.to, link.from);
        }
        for (std::size_t v = 0; v < count_; ++v) {
            const auto& s = sums[v];
            const glm::dmat3 matrix(s[0] + 1e-9, s[1], s[2], s[1], s[3] + 1e-9, s[4], s[2], s[4], s[5] + 1e-9);
            const glm::dvec3 result = glm::inverse(matrix) * glm::dvec3(s[6], s[7], s[8]);
            mean[v] = result.x;
            deviator[v] = Complex(result.y, result.z);
        }
    }

    /// Solves (diagonal + scale * Laplacian) z = right, the Laplacian with turns or without.
    void solve(const std::vector<double>& diagonal, double scale, bool turned, const std::vector<Complex>& right,
               std::vector<Complex>& z) const {
        std::vector<double> inverse = diagonal;
        for (const Link& link : links_) {
            inverse[link.from] += scale * link.weight;
            inverse[link.to] += scale * link.weight;
        }
        for (double& d : inverse) d = 1.0 / d;
        const auto apply = [&](const std::vector<Complex>& in, std::vector<Complex>& out) {
            for (std::size_t v = 0; v < count_; ++v) out[v] = diagonal[v] * in[v];
            for (const Link& link : links_) {
                const Complex turn = turned ? link.turn : 1.0, difference = in[link.to] - turn * in[link.from];
                out[link.to] += scale * link.weight * difference;
                out[link.from] -= scale * link.weight * std::conj(turn) * difference;
            }
        };
        const auto dot = [&](const std::vector<Complex>& a, const std::vector<Complex>& b) {
            double sum = 0.0;
            for (std::size_t v = 0; v < count_; ++v) sum += a[v].real() * b[v].real() + a[v].imag() * b[v].imag();
            return sum;
        };
        std::vector<Complex> r(count_), p(count_), q(count_), s(count_);
        apply(z, q);
        for (std::size_t v = 0; v < count_; ++v) r[v] = right[v] - q[v];
        for (std::size_t v = 0; v < count_; ++v) p[v] = s[v] = inverse[v] * r[v];
        double now = dot(r, s);
        const double goal = 1e-12 * now;
        for (int round = 0; round < 3000 && now > goal; ++round) {
            apply(p, q);
            const double step = now / dot(p, q);
            for (std::size_t v = 0; v < count_; ++v) {
                z[v] += step * p[v];
                r[v] -= step * q[v];
                s[v] = inverse[v] * r[v];
            }
            const double next = dot(r, s);
            for (std::size_t v = 0; v < count_; ++v) p[v] = s[v] + next / now * p[v];
            now = next;
        }
    }

    void solve_field(double detail) {
        glm::dvec3 low = position_[0], high = position_[0];
        for (const glm::dvec3& p : position_) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
        const double size = glm::length(high - low);
        std::vector<Complex> mean(count_), deviator(count_), right(count_);
        raw_curvature(mean, deviator);
        for (auto* field : {&mean, &deviator}) {
            for (std::size_t v = 0; v < count_; ++v) right[v] = mass_[v] * (*field)[v];
            solve(mass_, 0.5 * detail * detail * size * size, field == &deviator, right, *field);
        }
        std::vector<double> diagonal(count_);
        std::vector<Complex> line(count_);
        std::vector<double> sure(count_);
        for (std::size_t v = 0; v < count_; ++v) {
            const Complex wanted = 2.0 * mean[v].real() * deviator[v];
            const double h = std::abs(mean[v].real()), d = std::abs(deviator[v]), flat = 0.5 / size;
            const double ratio = 4.0 * h * d / (2.0 * (h * h + d * d) + flat * flat),
                         t = std::clamp((ratio - 0.1) / 0.4, 0.0, 1.0);
            sure[v] = t * t * (3.0 - 2.0 * t);
            const double strength = std::pow(sure[v] / (0.3 * detail * size), 2), fallback = 0.1 / (size * size);
            const glm::dvec3 along(0.1, 1.0, 0.0), a = x_[v], b = y(v);
            const Complex other(-0.5 * (glm::dot(a * a, along) - glm::dot(b * b, along)), -glm::dot(a * b, along));
            diagonal[v] = mass_[v] * (strength + fallback);
            right[v] =
                mass_[v] * (strength * (std::abs(wanted) > 0.0 ? wanted / std::abs(wanted) : 0.0) + fallback * other);
            line[v] = right[v] / diagonal[v];
        }
        solve(diagonal, 1.0, true, right, line);
        direction.resize(count_);
        confidence.resize(count_);
        for (std::size_t v = 0; v < count_; ++v) {
            const std::uint32_t p = place_[v];
            const double angle = 0.5 * std::arg(line[p]);
            direction[v] = std::cos(angle) * x_[p] + std::sin(angle) * y(p);
            confidence[v] = sure[p];
        }
    }

    std::vector<std::uint32_t> place_;
    std::size_t count_;
    std::vector<glm::dvec3> position_, normal_, x_;
    std::vector<double> mass_;
    std::vector<Link> links_;
};

} // namespace hachure::geometry::reference
