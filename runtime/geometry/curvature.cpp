#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/principal.h>
#include <hachure/runtime/geometry/triangle_frame.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure::geometry {
namespace {

constexpr double error_as_flat = 4.0;     // curvatures within so many times their error say nothing about directions
constexpr std::size_t write_block = 8192; // vertices that one task finishes

/// A symmetric tensor in some frame: e along u, g along v, f mixed.
struct Tensor {
    double e, f, g;
};

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

/// A tensor of the triangle's plane in the frame of a vertex.
Tensor in_frame_of(const glm::dvec3& vertex_normal, const Triangle& triangle, const Frame& frame, const Tensor& t) {
    const Frame own = turned(frame_of(vertex_normal), vertex_normal, triangle.normal);
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

/// What a tensor says of a vertex. `error`: the expected square of its error; `flat`: a curvature that counts as none.
void write(const CurvatureJob& job, std::size_t vertex, const Tensor& tensor, double error, double flat) {
    const Frame frame = frame_of(glm::dvec3(job.normals[job.weld[vertex]]));
    Principal result = principal(tensor.e, tensor.f, tensor.g);
    if (!std::isfinite(result.k1) || !std::isfinite(result.k2)) result = {0.0, 0.0, 1.0, 0.0};
    job.curvatures[vertex] = {result.k1, result.k2};
    job.directions[vertex] = result.x * frame.u + result.y * frame.v;
    if (job.confidences.empty()) return;
    const double mean = 0.5 * (result.k1 + result.k2), deviator = 0.5 * (result.k1 - result.k2);
    const double none = std::max(flat, error_as_flat * std::sqrt(error)), square = deviator * deviator;
    const double sure = square > 0.0 ? square / (square + error) : 0.0;
    job.confidences[vertex] = static_cast<float>(sure * direction_confidence(mean, deviator, none));
}

void average_triangles(CurvatureJob& job, double flat) {
    job.sums.assign(job.positions.size(), CurvatureJob::Sum{});
    for (std::size_t i = 0; i + 2 < job.indices.size(); i += 3) add_triangle(job, &job.indices[i]);
    for (std::size_t v = 0; v < job.positions.size(); ++v) {
        const CurvatureJob::Sum& sum = job.sums[job.weld[v]];
        const double inverse = sum.area > 0.0 ? 1.0 / sum.area : 0.0;
        write(job, v, {inverse * sum.e, inverse * sum.f, inverse * sum.g}, 0.0, flat);
    }
}

void fit_polynomials(CurvatureJob& job, double flat) {
    if (!job.neighbours) job.own_neighbours.build(job.indices, job.weld);
    const CurvedMesh mesh{job.positions, job.normals, job.weld, job.neighbours ? *job.neighbours : job.own_neighbours};
    const bool quartic = job.method == CurvatureMethod::quartic;
    const PatchExtent extent{.degree = quartic ? 4u : 2u,
                             .rings = job.rings > 0 ? job.rings
                                      : quartic     ? 3u
                                                    : 2u,
                             .radius = job.radius};
    if (job.method == CurvatureMethod::automatic)
        job.fits.choose(mesh, job.tolerance, flat);
    else
        job.fits.fit(mesh, extent);
    parallel_for((job.positions.size() + write_block - 1) / write_block, [&](std::size_t block) {
        for (std::size_t v = block * write_block; v < std::min(job.positions.size(), (block + 1) * write_block); ++v) {
            const CurvatureFits::Fit& fit = job.fits.result(job.weld[v]);
            write(job, v, {fit.e, fit.f, fit.g}, job.fits.error(job.weld[v]), flat);
        }
    });
}

} // namespace

void CurvatureJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(weld.size() == positions.size() && normals.size() == positions.size(), "one element per vertex");
    HACHURE_ASSERT(curvatures.size() == positions.size() && directions.size() == positions.size(),
                   "one element per vertex");
    HACHURE_ASSERT(confidences.empty() || confidences.size() == positions.size(), "one element per vertex, or none");
    HACHURE_ASSERT(radius >= 0.0 && tolerance >= 0.0, "lengths and errors are not negative");
    HACHURE_ASSERT(!neighbours || neighbours->first.size() == positions.size() + 1, "neighbours are of this mesh");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
}

void CurvatureJob::run() {
    const float size = glm::length(bounds_of(positions).extent());
    const double flat = size > 0.0f ? 0.5 / double{size} : 1.0; // as a direction field takes it
    if (method == CurvatureMethod::one_ring)
        average_triangles(*this, flat);
    else
        fit_polynomials(*this, flat);
}

} // namespace hachure::geometry
