#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/diffused_normals.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace hachure::geometry {
namespace {

/// 0 where nothing is left to do.
glm::dvec3 ratio(const glm::dvec3& a, const glm::dvec3& b) {
    glm::dvec3 result(0.0);
    for (int c = 0; c < 3; ++c)
        if (b[c] > 0.0) result[c] = a[c] / b[c];
    return result;
}

} // namespace

void DiffusedNormalsJob::validate() const {
    const std::size_t count = positions.size();
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(normals.size() == count && weld.size() == count && diffused.size() == count,
                   "one element per vertex");
    const auto in_range = [&](std::uint32_t i) { return i < count; };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
    HACHURE_ASSERT(radius >= 0.0, "a radius is not negative");
}

void DiffusedNormalsJob::assemble() {
    triangles.clear();
    triangles.reserve(indices.size() / 3);
    areas.assign(positions.size(), 0.0);
    diagonal.assign(positions.size(), 0.0);
    solution.assign(positions.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        Triangle triangle{};
        glm::dvec3 p[3];
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corner[k] = weld[indices[i + k]];
            p[k] = glm::dvec3(positions[triangle.corner[k]]);
        }
        const glm::dvec3 edge[3] = {p[2] - p[1], p[0] - p[2], p[1] - p[0]}; // opposite to each corner
        const double doubled = glm::length(glm::cross(edge[0], edge[1]));
        const double longest =
            std::max({glm::dot(edge[0], edge[0]), glm::dot(edge[1], edge[1]), glm::dot(edge[2], edge[2])});
        if (!(doubled > 1e-6 * longest)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.weight[k] = -0.5 * radius * radius * glm::dot(edge[(k + 1) % 3], edge[(k + 2) % 3]) / doubled;
            areas[triangle.corner[k]] += doubled / 6.0;
            solution[triangle.corner[k]] += doubled / 6.0 * glm::dvec3(normals[indices[i + k]]);
        }
        for (std::size_t k = 0; k < 3; ++k)
            diagonal[triangle.corner[k]] += triangle.weight[(k + 1) % 3] + triangle.weight[(k + 2) % 3];
        triangles.push_back(triangle);
    }
    // One unit normal at each place to begin with.
    for (std::size_t v = 0; v < solution.size(); ++v) {
        const double size = glm::length(solution[v]);
        solution[v] = size > 0.0 ? solution[v] / size : glm::dvec3(0.0);
        diagonal[v] += areas[v];
    }
}

/// product = (M + radius^2 S) direction, triangle by triangle: weight k joins the two other corners.
void DiffusedNormalsJob::multiply() {
    for (std::size_t v = 0; v < product.size(); ++v) product[v] = areas[v] * direction[v];
    for (const Triangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle.corner[(k + 1) % 3], b = triangle.corner[(k + 2) % 3];
            const glm::dvec3 flow = triangle.weight[k] * (direction[a] - direction[b]);
            product[a] += flow;
            product[b] -= flow;
        }
}

/// Conjugate gradients with the matrix's diagonal as preconditioner, for x, y and z beside each other.
void DiffusedNormalsJob::solve() {
    const std::size_t count = solution.size();
    product.resize(count);
    residual.resize(count);
    direction = solution;
    multiply();
    glm::dvec3 fit(0.0), whole(0.0);
    for (std::size_t v = 0; v < count; ++v) {
        const glm::dvec3 wanted = areas[v] * solution[v];
        residual[v] = wanted - product[v];
        direction[v] = areas[v] > 0.0 ? residual[v] / diagonal[v] : glm::dvec3(0.0);
        fit += residual[v] * direction[v];
        if (areas[v] > 0.0) whole += wanted * wanted / diagonal[v];
    }
    const double enough = tolerance * tolerance * (whole.x + whole.y + whole.z);
    for (steps = 0; steps < max_steps && fit.x + fit.y + fit.z > enough; ++steps) {
        multiply();
        glm::dvec3 bend(0.0);
        for (std::size_t v = 0; v < count; ++v) bend += direction[v] * product[v];
        const glm::dvec3 step = ratio(fit, bend);
        glm::dvec3 next(0.0);
        for (std::size_t v = 0; v < count; ++v) {
            solution[v] += step * direction[v];
            residual[v] -= step * product[v];
            if (areas[v] > 0.0) next += residual[v] * residual[v] / diagonal[v];
        }
        const glm::dvec3 keep = ratio(next, fit);
        for (std::size_t v = 0; v < count; ++v)
            direction[v] = (areas[v] > 0.0 ? residual[v] / diagonal[v] : glm::dvec3(0.0)) + keep * direction[v];
        fit = next;
    }
}

void DiffusedNormalsJob::run() {
    assemble();
    solve();
    for (std::size_t v = 0; v < diffused.size(); ++v) {
        const glm::dvec3& sum = solution[weld[v]];
        const double size = glm::length(sum);
        diffused[v] = size > 1e-9 ? glm::vec3(sum / size) : normals[v];
    }
}

} // namespace hachure::geometry
