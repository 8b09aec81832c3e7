#pragma once

#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/weld.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

/// Surfaces whose curvature is known in closed form, in double, and meshes of them: regular or not, with or without
/// noise. For tests and benchmarks of curvature.
namespace hachure::test {

enum class CurvedKind { sphere, torus, ellipsoid, cylinder, monkey_saddle };

/// The surface F(p) = 0 by its derivatives; its normal is along the gradient.
struct CurvedSurface {
    CurvedKind kind;
    static constexpr double major = 1.0, minor = 0.4; // torus around Y
    static constexpr double radius = 0.5;             // cylinder along Y
    static constexpr glm::dvec3 axes{1.5, 1.0, 0.7};  // ellipsoid
    static constexpr double bend = 0.5;               // y = bend (x^3 - 3 x z^2)

    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& p) const {
        switch (kind) {
        case CurvedKind::sphere:
            return p;
        case CurvedKind::ellipsoid:
            return p / (axes * axes);
        case CurvedKind::cylinder:
            return {p.x, 0.0, p.z};
        case CurvedKind::monkey_saddle:
            return {-3.0 * bend * (p.x * p.x - p.z * p.z), 1.0, 6.0 * bend * p.x * p.z};
        case CurvedKind::torus: {
            const double ring = std::hypot(p.x, p.z), out = 1.0 - major / ring;
            return {out * p.x, p.y, out * p.z};
        }
        }
        return {};
    }
    [[nodiscard]] glm::dmat3 hessian(const glm::dvec3& p) const {
        glm::dmat3 h(0.0);
        switch (kind) {
        case CurvedKind::sphere:
            return glm::dmat3(1.0);
        case CurvedKind::ellipsoid:
            for (int i = 0; i < 3; ++i) h[i][i] = 1.0 / (axes[i] * axes[i]);
            return h;
        case CurvedKind::cylinder:
            h[0][0] = h[2][2] = 1.0;
            return h;
        case CurvedKind::monkey_saddle:
            h[0][0] = -6.0 * bend * p.x;
            h[2][2] = 6.0 * bend * p.x;
            h[0][2] = h[2][0] = 6.0 * bend * p.z;
            return h;
        case CurvedKind::torus: {
            const double ring = std::hypot(p.x, p.z), cube = ring * ring * ring;
            h[0][0] = 1.0 - major * p.z * p.z / cube;
            h[2][2] = 1.0 - major * p.x * p.x / cube;
            h[0][2] = h[2][0] = major * p.x * p.z / cube;
            h[1][1] = 1.0;
            return h;
        }
        }
        return h;
    }
};

/// Principal curvatures at a place, the greater first, and the direction of the one that is larger in size.
struct CurvatureTruth {
    glm::dvec3 normal;
    double greater, less;
    glm::dvec3 direction;

    /// The shape operator is the Hessian on the tangent plane over the size of the gradient.
    [[nodiscard]] static CurvatureTruth at(const CurvedSurface& surface, const glm::dvec3& p) {
        const glm::dvec3 gradient = surface.gradient(p), n = glm::normalize(gradient);
        const glm::dvec3 any = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 a = glm::normalize(glm::cross(n, any)), b = glm::cross(n, a);
        const glm::dmat3 h = surface.hessian(p) / glm::length(gradient);
        const double aa = glm::dot(a, h * a), ab = glm::dot(a, h * b), bb = glm::dot(b, h * b);
        const double mean = 0.5 * (aa + bb), spread = std::hypot(0.5 * (aa - bb), ab);
        double angle = 0.5 * std::atan2(ab, 0.5 * (aa - bb)); // of the greater one
        if (mean < 0.0) angle += 0.5 * std::numbers::pi;
        return {n, mean + spread, mean - spread, std::cos(angle) * a + std::sin(angle) * b};
    }
};

/// A mesh of a surface, with the truth at each vertex before it was moved by noise.
struct CurvedCase {
    CurvedSurface surface;
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices, weld;
    std::vector<CurvatureTruth> truth;
    std::vector<bool> border;
    double edge = 0.0;  ///< the mean length
    double scale = 0.0; ///< the largest size of a curvature

    struct Options {
        bool irregular = true;
        double noise = 0.0;       ///< standard deviation along each axis, over the mean length of edges
        std::uint32_t cells = 64; ///< across
        std::uint32_t seed = 7;
    };

    CurvedCase(CurvedKind kind, const Options& options) : surface{kind} {
        std::mt19937 random(options.seed);
        make(options, random);
        weld = geometry::weld_positions(positions);
        for (const glm::vec3& p : positions) truth.push_back(CurvatureTruth::at(surface, glm::dvec3(p)));
        for (const CurvatureTruth& t : truth) scale = std::max({scale, std::abs(t.greater), std::abs(t.less)});
        measure_edges();
        add_noise(options.noise, random);
        normals.resize(positions.size());
        geometry::SmoothNormalsJob smooth{.positions = positions, .indices = indices, .weld = weld, .normals = normals};
        smooth.run();
    }

    struct Errors {
        double rms = 0.0;       ///< of both curvatures, over the largest one of the surface
        double degrees95 = 0.0; ///< of the principal cross, in the tangent plane: 95th percentile
    };

    /// Of what a CurvatureJob gave, off the border; of directions where the curvatures differ by a tenth of the
    /// largest.
    [[nodiscard]] Errors errors(std::span<const glm::vec2> curvatures, std::span<const glm::vec3> directions) const {
        double sum = 0.0, count = 0.0;
        std::vector<double> degrees;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            if (border[v]) continue;
            const glm::dvec2 k(curvatures[v]);
            sum += std::pow(std::max(k.x, k.y) - truth[v].greater, 2) + std::pow(std::min(k.x, k.y) - truth[v].less, 2);
            count += 2.0;
            if (truth[v].greater - truth[v].less > 0.1 * scale) degrees.push_back(cross_degrees(v, directions[v]));
        }
        if (degrees.empty()) degrees.push_back(0.0);
        std::ranges::sort(degrees);
        return {std::sqrt(sum / count) / scale, degrees[degrees.size() * 95 / 100]};
    }

private:
    double cross_degrees(std::size_t v, const glm::dvec3& direction) const {
        // Both in the plane across the true normal: how far the vertex's own normal is off is another question.
        const CurvatureTruth& t = truth[v];
        const double x = glm::dot(direction, t.direction), y = glm::dot(direction, glm::cross(t.normal, t.direction));
        const double degrees = std::atan2(std::abs(y), std::abs(x)) * 180.0 / std::numbers::pi;
        return std::min(degrees, 90.0 - degrees);
    }

    void make(const Options& options, std::mt19937& random) {
        const std::uint32_t n = options.cells;
        if (surface.kind == CurvedKind::torus) {
            const double major = CurvedSurface::major, minor = CurvedSurface::minor;
            take(options.irregular ? geometry::irregular_torus(major, minor, 5 * n / 2, n, 0.33, 5)
                                   : geometry::torus(major, minor, 5 * n / 2, n));
        } else if (surface.kind == CurvedKind::sphere || surface.kind == CurvedKind::ellipsoid) {
            make_ball(n, options.irregular, random);
        } else {
            make_sheet(n, options.irregular ? 0.33 : 0.0, random);
        }
    }

    void take(const geometry::Shape& shape) {
        positions = shape.positions;
        indices = shape.indices;
        border.assign(positions.size(), false);
    }

    void make_ball(std::uint32_t cells, bool irregular, std::mt19937& random) {
        std::uint32_t level = 1;
        while ((2u << level) < cells && level < 8) ++level;
        take(geometry::icosphere(1.0, level));
        std::uniform_real_distribution<double> shift(-1.0, 1.0);
        for (glm::vec3& p : positions) {
            glm::dvec3 q(p);
            if (irregular) q += 0.25 / (1u << level) * glm::dvec3(shift(random), shift(random), shift(random));
            p = glm::vec3(glm::normalize(q) * (surface.kind == CurvedKind::sphere ? glm::dvec3(1.0) : surface.axes));
        }
    }

    /// A rectangle with borders: all of a saddle, or a cylinder's side.
    void make_sheet(std::uint32_t n, double jitter, std::mt19937& random) {
        const bool closed = surface.kind == CurvedKind::cylinder;
        const std::uint32_t wide = closed ? 3 * n / 2 : n, columns = closed ? wide : wide + 1, rows = n + 1;
        std::uniform_real_distribution<double> shift(-1.0, 1.0);
        for (std::uint32_t i = 0; i < columns; ++i)
            for (std::uint32_t j = 0; j < rows; ++j) {
                const bool on_side = !closed && (i == 0 || i == wide), on_end = j == 0 || j == n;
                const double a = (i + (on_side ? 0.0 : jitter * shift(random))) / wide;
                const double b = 2.0 * (j + (on_end ? 0.0 : jitter * shift(random))) / n - 1.0;
                positions.push_back(on_sheet(a, b));
                border.push_back(on_side || on_end);
            }
        for (std::uint32_t i = 0; i < wide; ++i)
            for (std::uint32_t j = 0; j < n; ++j) {
                const std::uint32_t p = i * rows + j, q = (i + 1) % columns * rows + j;
                if (jitter > 0.0 && shift(random) < 0.0)
                    indices.insert(indices.end(), {p, p + 1, q, p + 1, q + 1, q});
                else
                    indices.insert(indices.end(), {p, p + 1, q + 1, p, q + 1, q});
            }
    }

    [[nodiscard]] glm::vec3 on_sheet(double a, double b) const {
        if (surface.kind == CurvedKind::cylinder) {
            const double angle = 2.0 * std::numbers::pi * a;
            return {surface.radius * std::cos(angle), b, surface.radius * std::sin(angle)};
        }
        const double x = 2.0 * a - 1.0;
        return {x, surface.bend * (x * x * x - 3.0 * x * b * b), b};
    }

    void measure_edges() {
        for (std::size_t i = 0; i < indices.size(); ++i)
            edge += glm::distance(positions[indices[i]], positions[indices[i % 3 == 2 ? i - 2 : i + 1]]);
        edge /= static_cast<double>(indices.size());
    }

    /// Vertices at one place stay together.
    void add_noise(double noise, std::mt19937& random) {
        std::normal_distribution<double> along(0.0, noise * edge);
        if (noise > 0.0)
            for (std::size_t v = 0; v < positions.size(); ++v)
                positions[v] =
                    weld[v] == v
                        ? glm::vec3(glm::dvec3(positions[v]) + glm::dvec3(along(random), along(random), along(random)))
                        : positions[weld[v]];
    }
};

} // namespace hachure::test
