#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/stripe_frames.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

/// What is added by add_triangle below.
enum class Added { all, turning };

/// Adds what one triangle with these normals says to the vertices that stand for its corners.
template <class Normal>
void add_triangle(StripeFramesJob& job, std::span<Normal> normals, const std::uint32_t* corner, Added added) {
    glm::dvec3 p[3], n[3];
    double u[3];
    for (int k = 0; k < 3; ++k) {
        p[k] = job.positions[corner[k]];
        n[k] = glm::vec3(normals[corner[k]]);
        u[k] = job.coordinate[corner[k]];
    }
    const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0], cross = glm::cross(a, b);
    const double square = glm::dot(cross, cross), aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b);
    if (!(square > 1e-12 * std::max(aa, bb) * std::max(aa, bb))) return;
    // The tangent vectors dual to a and b: what grows by 1 along one edge and by 0 along the other.
    const glm::dvec3 dual_a = (bb * a - ab * b) / square, dual_b = (aa * b - ab * a) / square;
    const glm::dvec3 gradient = (u[1] - u[0]) * dual_a + (u[2] - u[0]) * dual_b;
    const double steepness = glm::length(gradient);
    if (!(steepness > 0.0) || !std::isfinite(steepness)) return;
    const glm::dvec3 x = gradient / steepness;
    const double turning = glm::dot((n[1] - n[0]) * glm::dot(dual_a, x) + (n[2] - n[0]) * glm::dot(dual_b, x), x);
    const double weight = std::sqrt(square);
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = corner[k], stands = job.stands_for.empty() ? v : job.stands_for[v];
        const double sign = !job.mirrored.empty() && job.mirrored[v] != 0 ? -1.0 : 1.0;
        StripeFramesJob::Sum& sum = job.sums[stands];
        sum.turning += weight * turning;
        if (added == Added::turning) continue;
        sum.gradient += sign * weight * gradient;
        sum.steepness += weight * steepness;
        sum.weight += weight;
    }
}

/// A unit tangent perpendicular to a normal (Duff et al. 2017).
glm::dvec3 any_tangent(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z);
    return {1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

const StripeFramesJob::Sum& sum_at(const StripeFramesJob& job, std::size_t vertex) {
    return job.sums[job.stands_for.empty() ? vertex : job.stands_for[vertex]];
}

glm::vec4 frame_of(const StripeFramesJob& job, const glm::vec3& normal, std::size_t vertex) {
    const StripeFramesJob::Sum& sum = sum_at(job, vertex);
    const glm::dvec3 n(normal);
    const glm::dvec3 tangent = sum.gradient - glm::dot(sum.gradient, n) * n;
    const double length = glm::length(tangent);
    if (!(length > 1e-9 * sum.steepness) || !std::isfinite(length)) return {glm::vec3(any_tangent(n)), 0.0f};
    const double sign = !job.mirrored.empty() && job.mirrored[vertex] != 0 ? -1.0 : 1.0;
    const auto kappa = static_cast<float>(sum.turning / sum.steepness);
    return {glm::vec3(sign * tangent / length), std::isfinite(kappa) ? kappa : 0.0f};
}

glm::vec3 smooth_normal_of(const StripeFramesJob& job, std::size_t vertex) {
    const glm::vec3 n = job.normals[vertex], x(frame_of(job, n, vertex)), lean = job.lean[vertex];
    const glm::vec3 normal = lean.x * x + lean.y * glm::cross(n, x) + lean.z * n;
    const float length = glm::length(normal);
    return length > 1e-6f && std::isfinite(length) ? normal / length : n;
}

} // namespace

void StripeFramesJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(normals.size() == positions.size() && coordinate.size() == positions.size() &&
                       frames.size() == positions.size(),
                   "one element per vertex");
    HACHURE_ASSERT(stands_for.size() == mirrored.size() &&
                       (stands_for.empty() || stands_for.size() == positions.size()),
                   "one element per vertex, or none");
    HACHURE_ASSERT(lean.size() == smooth_normals.size() && (lean.empty() || lean.size() == positions.size()),
                   "one element per vertex, or none");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(stands_for, in_range),
                   "indices must be in range");
}

void StripeFramesJob::run() {
    sums.assign(positions.size(), Sum{glm::dvec3(0.0), 0.0, 0.0, 0.0});
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) add_triangle(*this, normals, &indices[i], Added::all);
    if (lean.empty()) {
        for (std::size_t v = 0; v < positions.size(); ++v) frames[v] = frame_of(*this, normals[v], v);
        return;
    }
    for (std::size_t v = 0; v < positions.size(); ++v) smooth_normals[v] = glm::vec4(smooth_normal_of(*this, v), 0.0f);
    for (Sum& sum : sums) sum.turning = 0.0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        add_triangle(*this, smooth_normals, &indices[i], Added::turning);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        frames[v] = frame_of(*this, glm::vec3(smooth_normals[v]), v);
        const Sum& sum = sum_at(*this, v);
        if (sum.weight > 0.0) smooth_normals[v].w = static_cast<float>(sum.turning / sum.weight);
    }
}

} // namespace hachure::geometry
