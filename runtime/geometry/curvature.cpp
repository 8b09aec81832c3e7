#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/principal.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure::geometry {
namespace {

/// Two unit vectors perpendicular to a unit normal and to each other: a function of the normal alone, so that frames
/// need not be stored (Duff et al. 2017).
struct Frame {
    glm::dvec3 u, v;
};

Frame frame_of(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// A symmetric tensor in some frame: e along u, g along v, f mixed.
struct Tensor {
    double e, f, g;
};

/// One triangle: edge k lies opposite corner k.
struct Triangle {
    glm::dvec3 edge[3], normal; ///< the normal is unit
    double square[3], area;     ///< squared lengths of the edges
};

/// Whether the triangle has a normal to be trusted: one with a height under 1e-6 of its longest edge has not.
bool measure(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2, Triangle& triangle) {
    triangle.edge[0] = p2 - p1;
    triangle.edge[1] = p0 - p2;
    triangle.edge[2] = p1 - p0;
    for (int k = 0; k < 3; ++k) triangle.square[k] = glm::dot(triangle.edge[k], triangle.edge[k]);
    const glm::dvec3 cross = glm::cross(triangle.edge[0], triangle.edge[1]);
    const double length = glm::length(cross);
    if (!(length > 1e-6 * std::max({triangle.square[0], triangle.square[1], triangle.square[2]}))) return false;
    triangle.normal = cross / length;
    triangle.area = 0.5 * length;
    return true;
}

/// The tensor that takes the triangle's edges to the differences of normals along them, in the least squares of its six
/// equations (section 3.2 of the paper), in the frame (u along edge 0, v).
Tensor fit(const Triangle& triangle, const Frame& frame, const glm::dvec3 (&normals)[3]) {
    double a = 0.0, b = 0.0, c = 0.0, right[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 difference = normals[(k + 2) % 3] - normals[(k + 1) % 3];
        const double u = glm::dot(triangle.edge[k], frame.u), v = glm::dot(triangle.edge[k], frame.v);
        const double du = glm::dot(difference, frame.u), dv = glm::dot(difference, frame.v);
        a += u * u;
        b += u * v;
        c += v * v;
        right[0] += du * u;
        right[1] += du * v + dv * u;
        right[2] += dv * v;
    }
    // The normal equations (a b 0; b a+c b; 0 b c) by their cofactors.
    const double sum = a + c, inverse = 1.0 / (sum * (a * c - b * b));
    return {inverse * ((sum * c - b * b) * right[0] - b * c * right[1] + b * b * right[2]),
            inverse * (-b * c * right[0] + a * c * right[1] - a * b * right[2]),
            inverse * (b * b * right[0] - a * b * right[1] + (sum * a - b * b) * right[2])};
}

/// The part of the triangle's area nearest to each corner (Meyer et al. 2003): Voronoi, and where the triangle is
/// obtuse what stays inside it.
void corner_areas(const Triangle& t, double (&areas)[3]) {
    const double* l = t.square;
    const double w[3] = {l[0] * (l[1] + l[2] - l[0]), l[1] * (l[2] + l[0] - l[1]), l[2] * (l[0] + l[1] - l[2])};
    for (int k = 0; k < 3; ++k) {
        if (w[k] > 0.0) continue; // obtuse at corner k, or right-angled
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        areas[i] = -0.25 * l[j] * t.area / glm::dot(t.edge[k], t.edge[j]);
        areas[j] = -0.25 * l[i] * t.area / glm::dot(t.edge[k], t.edge[i]);
        areas[k] = t.area - areas[i] - areas[j];
        return;
    }
    const double scale = 0.5 * t.area / (w[0] + w[1] + w[2]);
    for (int k = 0; k < 3; ++k) areas[k] = scale * (w[(k + 1) % 3] + w[(k + 2) % 3]);
}

/// A tensor of the triangle's plane in the frame of a vertex, whose plane is first turned into the triangle's about the
/// line where they meet, so that curvature is not lost to the angle between them.
Tensor in_frame_of(const glm::dvec3& vertex_normal, const Triangle& triangle, const Frame& frame, const Tensor& t) {
    Frame own = frame_of(vertex_normal);
    const double cosine = glm::dot(vertex_normal, triangle.normal);
    if (cosine > -1.0 + 1e-9) {
        const glm::dvec3 across = triangle.normal - cosine * vertex_normal;
        const glm::dvec3 turn = (triangle.normal + vertex_normal) / (1.0 + cosine);
        own.u -= turn * glm::dot(own.u, across);
        own.v -= turn * glm::dot(own.v, across);
    } else {
        own = {-own.u, -own.v};
    }
    const double u1 = glm::dot(own.u, frame.u), v1 = glm::dot(own.u, frame.v);
    const double u2 = glm::dot(own.v, frame.u), v2 = glm::dot(own.v, frame.v);
    return {t.e * u1 * u1 + 2.0 * t.f * u1 * v1 + t.g * v1 * v1,
            t.e * u1 * u2 + t.f * (u1 * v2 + u2 * v1) + t.g * v1 * v2,
            t.e * u2 * u2 + 2.0 * t.f * u2 * v2 + t.g * v2 * v2};
}

/// Adds what one triangle says to its three corners.
void add_triangle(CurvatureJob& job, const std::uint32_t* corner) {
    const std::uint32_t place[3] = {job.weld[corner[0]], job.weld[corner[1]], job.weld[corner[2]]};
    Triangle triangle;
    if (!measure(job.positions[place[0]], job.positions[place[1]], job.positions[place[2]], triangle)) return;
    glm::dvec3 normals[3];
    for (int k = 0; k < 3; ++k) normals[k] = job.normals[place[k]];
    const glm::dvec3 u = triangle.edge[0] / std::sqrt(triangle.square[0]);
    const Frame frame{u, glm::cross(triangle.normal, u)};
    const Tensor tensor = fit(triangle, frame, normals);
    double areas[3];
    corner_areas(triangle, areas);
    for (int k = 0; k < 3; ++k) {
        const Tensor own = in_frame_of(normals[k], triangle, frame, tensor);
        CurvatureJob::Sum& sum = job.sums[place[k]];
        sum.area += areas[k];
        sum.e += areas[k] * own.e;
        sum.f += areas[k] * own.f;
        sum.g += areas[k] * own.g;
    }
}

/// What the sums say of a vertex.
void finish(const CurvatureJob& job, std::size_t vertex) {
    const CurvatureJob::Sum& sum = job.sums[job.weld[vertex]];
    const Frame frame = frame_of(glm::dvec3(job.normals[job.weld[vertex]]));
    const double inverse = sum.area > 0.0 ? 1.0 / sum.area : 0.0;
    Principal result = principal(inverse * sum.e, inverse * sum.f, inverse * sum.g);
    if (!std::isfinite(result.k1) || !std::isfinite(result.k2)) result = {0.0, 0.0, 1.0, 0.0};
    job.curvatures[vertex] = {result.k1, result.k2};
    job.directions[vertex] = result.x * frame.u + result.y * frame.v;
}

} // namespace

void CurvatureJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(weld.size() == positions.size() && normals.size() == positions.size(), "one element per vertex");
    HACHURE_ASSERT(curvatures.size() == positions.size() && directions.size() == positions.size(),
                   "one element per vertex");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
}

void CurvatureJob::run() {
    sums.assign(positions.size(), Sum{});
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) add_triangle(*this, &indices[i]);
    for (std::size_t v = 0; v < positions.size(); ++v) finish(*this, v);
}

} // namespace hachure::geometry
