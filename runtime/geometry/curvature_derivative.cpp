#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/curvature_derivative.h>
#include <hachure/runtime/geometry/triangle_frame.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hachure::geometry {
namespace {

/// C(u, u, u), C(u, u, v), C(u, v, v), C(v, v, v) in some frame.
using Derivative = std::array<double, 4>;

/// A frame's vectors in the coordinates of another one of the same plane.
struct Coordinates {
    double u1, v1, u2, v2;
};

Coordinates coordinates(const Frame& own, const Frame& frame) {
    return {glm::dot(own.u, frame.u), glm::dot(own.u, frame.v), glm::dot(own.v, frame.u), glm::dot(own.v, frame.v)};
}

/// The principal frame of a vertex, turned into the plane of the triangle.
Frame principal_frame(const CurvatureDerivativeJob& job, std::uint32_t vertex, const Triangle& triangle) {
    const glm::dvec3 normal(job.normals[vertex]), first(job.directions[vertex]);
    return turned({first, glm::cross(normal, first)}, normal, triangle.normal);
}

/// The derivative that takes the triangle's edges to the differences of curvature tensors along them, in the least
/// squares of its nine equations (section 4 of the paper). Mixed elements count twice, as they stand in the tensor
/// twice. The normal equations have three diagonals.
Derivative fit(const Triangle& triangle, const Frame& frame, const double (&e)[3], const double (&f)[3],
               const double (&g)[3]) {
    double uu = 0.0, uv = 0.0, vv = 0.0;
    Derivative right{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = (k + 1) % 3, to = (k + 2) % 3;
        const double u = glm::dot(triangle.edge[k], frame.u), v = glm::dot(triangle.edge[k], frame.v);
        const double de = e[to] - e[from], df = f[to] - f[from], dg = g[to] - g[from];
        uu += u * u;
        uv += u * v;
        vv += v * v;
        right[0] += u * de;
        right[1] += v * de + 2.0 * u * df;
        right[2] += 2.0 * v * df + u * dg;
        right[3] += v * dg;
    }
    const double beside[3] = {uv, 2.0 * uv, uv};
    double diagonal[4] = {uu, vv + 2.0 * uu, 2.0 * vv + uu, vv};
    for (std::size_t i = 1; i < 4; ++i) {
        const double factor = beside[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * beside[i - 1];
        right[i] -= factor * right[i - 1];
    }
    Derivative result{};
    result[3] = right[3] / diagonal[3];
    for (std::size_t i = 3; i-- > 0;) result[i] = (right[i] - beside[i] * result[i + 1]) / diagonal[i];
    return result;
}

Derivative in_coordinates(const Derivative& c, const Coordinates& to) {
    const auto [u1, v1, u2, v2] = to;
    // C(x, y, .) in the old frame for the pairs of new vectors, then the third.
    const auto along = [&](double xu, double xv, double yu, double yv, double zu, double zv) {
        const double u = c[0] * xu * yu + c[1] * (xu * yv + xv * yu) + c[2] * xv * yv;
        const double v = c[1] * xu * yu + c[2] * (xu * yv + xv * yu) + c[3] * xv * yv;
        return u * zu + v * zv;
    };
    return {along(u1, v1, u1, v1, u1, v1), along(u1, v1, u1, v1, u2, v2), along(u1, v1, u2, v2, u2, v2),
            along(u2, v2, u2, v2, u2, v2)};
}

/// Adds what one triangle says to its three corners.
void add_triangle(CurvatureDerivativeJob& job, const std::uint32_t* corner) {
    const std::uint32_t place[3] = {job.weld[corner[0]], job.weld[corner[1]], job.weld[corner[2]]};
    Triangle triangle;
    if (!measure(job.positions[place[0]], job.positions[place[1]], job.positions[place[2]], triangle)) return;
    const glm::dvec3 u = triangle.edge[0] / std::sqrt(triangle.square[0]);
    const Frame frame{u, glm::cross(triangle.normal, u)};
    Coordinates at[3];
    double e[3], f[3], g[3];
    for (std::size_t k = 0; k < 3; ++k) {
        at[k] = coordinates(principal_frame(job, place[k], triangle), frame);
        const double k1 = job.curvatures[place[k]].x, k2 = job.curvatures[place[k]].y;
        e[k] = k1 * at[k].u1 * at[k].u1 + k2 * at[k].u2 * at[k].u2;
        f[k] = k1 * at[k].u1 * at[k].v1 + k2 * at[k].u2 * at[k].v2;
        g[k] = k1 * at[k].v1 * at[k].v1 + k2 * at[k].v2 * at[k].v2;
    }
    const Derivative derivative = fit(triangle, frame, e, f, g);
    double areas[3];
    corner_areas(triangle, areas);
    for (std::size_t k = 0; k < 3; ++k) {
        const Derivative own = in_coordinates(derivative, at[k]);
        CurvatureDerivativeJob::Sum& sum = job.sums[place[k]];
        sum.area += areas[k];
        for (std::size_t i = 0; i < 4; ++i) sum.c[i] += areas[k] * own[i];
    }
}

} // namespace

void CurvatureDerivativeJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    for (const std::size_t size :
         {normals.size(), weld.size(), curvatures.size(), directions.size(), derivatives.size()})
        HACHURE_ASSERT(size == positions.size(), "one element per vertex");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
}

void CurvatureDerivativeJob::run() {
    sums.assign(positions.size(), Sum{});
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) add_triangle(*this, &indices[i]);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Sum& sum = sums[weld[v]];
        const double inverse = sum.area > 0.0 ? 1.0 / sum.area : 0.0;
        glm::vec4 result(inverse * glm::dvec4(sum.c[0], sum.c[1], sum.c[2], sum.c[3]));
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(result[i])) result = glm::vec4(0.0f);
        derivatives[v] = result;
    }
}

} // namespace hachure::geometry
