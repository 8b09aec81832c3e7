#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/fitted_normals.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hachure::geometry {
namespace {

/// Turns the axes so that `matrix`, symmetric, is diagonal in them: Jacobi's rotations, which are exact to rounding
/// after a few sweeps.
void diagonalize(glm::dmat3& matrix, glm::dmat3& axes) {
    for (int sweep = 0; sweep < 12; ++sweep)
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (matrix[p][q] == 0.0) continue;
                const double tau = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
                const double t = (tau >= 0.0 ? 1.0 : -1.0) / (std::abs(tau) + std::sqrt(1.0 + tau * tau));
                const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
                glm::dmat3 turn(1.0);
                turn[p][p] = turn[q][q] = c;
                turn[p][q] = -s;
                turn[q][p] = s;
                matrix = glm::transpose(turn) * matrix * turn;
                axes = axes * turn;
            }
}

void sort_axes(SurfaceMoments& moments) {
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, [&](int a, int b) { return moments.variances[a] > moments.variances[b]; });
    const SurfaceMoments before = moments;
    for (int i = 0; i < 3; ++i) {
        moments.axes[i] = before.axes[order[static_cast<std::size_t>(i)]];
        moments.variances[i] = before.variances[order[static_cast<std::size_t>(i)]];
    }
}

/// Calls `visit(area, three corners)` for the triangles; where none has an area, for each vertex as one.
template <class Visit>
void each_part(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, const Visit& visit) {
    double total = 0.0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::dvec3 a(positions[indices[i]]), b(positions[indices[i + 1]]), c(positions[indices[i + 2]]);
        const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
        total += area;
        if (area > 0.0) visit(area, a, b, c);
    }
    if (total > 0.0) return;
    for (const glm::vec3& position : positions)
        visit(1.0, glm::dvec3(position), glm::dvec3(position), glm::dvec3(position));
}

} // namespace

SurfaceMoments surface_moments(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    SurfaceMoments moments;
    double total = 0.0;
    glm::dvec3 sum(0.0);
    each_part(positions, indices, [&](double area, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        total += area;
        sum += area / 3.0 * (a + b + c);
    });
    if (!(total > 0.0)) return moments;
    moments.center = sum / total;
    glm::dmat3 covariance(0.0);
    // The mean of u u^T over a triangle is (sum of its corners' u u^T + s s^T) / 12, s the sum of its corners.
    each_part(positions, indices, [&](double area, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
        a -= moments.center;
        b -= moments.center;
        c -= moments.center;
        for (const glm::dvec3& u : {a, b, c, a + b + c}) covariance += area / (12.0 * total) * glm::outerProduct(u, u);
    });
    diagonalize(covariance, moments.axes);
    moments.variances = {covariance[0][0], covariance[1][1], covariance[2][2]};
    sort_axes(moments);
    return moments;
}

void FittedNormalsJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(normals.size() == positions.size() && fitted.size() == positions.size(), "one element per vertex");
    HACHURE_ASSERT(std::ranges::all_of(indices, [&](std::uint32_t i) { return i < positions.size(); }),
                   "indices must be in range");
}

void FittedNormalsJob::run() {
    const SurfaceMoments moments = surface_moments(positions, indices);
    // A flat surface is the ellipsoid of a plate: a hundredth of its width thick.
    glm::dvec3 scale(1.0);
    if (shape == FittedShape::ellipsoid)
        scale = 1.0 / glm::max(moments.variances, glm::dvec3(1e-4 * moments.variances[0] + 1e-300));
    if (shape == FittedShape::cylinder) scale[0] = 0.0;
    for (std::size_t v = 0; v < fitted.size(); ++v) {
        const glm::dvec3 away = glm::dvec3(positions[v]) - moments.center;
        // Brought to a common size first: variances of large scenes are far from 1.
        const glm::dvec3 along = glm::transpose(moments.axes) * away;
        const glm::dvec3 normal = moments.axes * (along * (scale / std::max({scale.x, scale.y, scale.z})));
        const double size = glm::length(normal);
        fitted[v] = size > 1e-5 * glm::length(away) ? glm::vec3(normal / size) : normals[v];
    }
}

} // namespace hachure::geometry
