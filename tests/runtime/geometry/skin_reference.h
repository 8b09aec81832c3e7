#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <utility>
#include <vector>

/// Skinning in double by its textbook formulas, from a list of joints and weights per vertex.
namespace hachure::geometry::reference {

using VertexJoints = std::vector<std::pair<std::size_t, double>>;

/// The influences of one vertex, as any program would read them from a valid file.
inline VertexJoints normalised(VertexJoints joints) {
    double sum = 0.0;
    for (const auto& [joint, weight] : joints) sum += weight;
    for (auto& [joint, weight] : joints) weight /= sum;
    return joints;
}

inline glm::dmat4 linear_blend(const VertexJoints& joints, std::span<const glm::dmat4> matrices) {
    glm::dmat4 sum(0.0);
    for (const auto& [joint, weight] : joints) sum += matrices[joint] * weight;
    return sum;
}

/// Of rigid matrices (Kavan et al. 2008): quaternions blended with signs by the heaviest, the dual parts alike.
inline glm::dmat4 dual_quaternion_blend(const VertexJoints& joints, std::span<const glm::dmat4> matrices) {
    std::size_t heaviest = 0;
    for (std::size_t k = 1; k < joints.size(); ++k)
        if (joints[k].second > joints[heaviest].second) heaviest = k;
    const glm::dquat first = glm::quat_cast(glm::dmat3(matrices[joints[heaviest].first]));
    glm::dquat real(0, 0, 0, 0), dual(0, 0, 0, 0);
    for (const auto& [joint, weight] : joints) {
        const glm::dquat q = glm::quat_cast(glm::dmat3(matrices[joint]));
        const double sign = glm::dot(q, first) < 0.0 ? -weight : weight;
        const glm::dvec3 t(matrices[joint][3]);
        real = real + sign * q;
        dual = dual + sign * 0.5 * (glm::dquat(0.0, t.x, t.y, t.z) * q);
    }
    const double length = glm::length(real);
    real = real / length;
    dual = dual / length;
    const glm::dquat t = 2.0 * (dual * glm::conjugate(real));
    glm::dmat4 result = glm::mat4_cast(real);
    result[3] = {t.x, t.y, t.z, 1.0};
    return result;
}

/// The inverse transpose, which keeps outward normals outward also where the matrix mirrors.
inline glm::dvec3 normal(const glm::dmat4& m, const glm::dvec3& n) {
    return glm::normalize(glm::inverse(glm::transpose(glm::dmat3(m))) * n);
}

inline glm::dvec3 point(const glm::dmat4& m, const glm::dvec3& p) { return {m * glm::dvec4(p, 1.0)}; }

inline glm::dmat4 random_rigid(std::mt19937& random, double reach = 1.0) {
    std::normal_distribution<double> normal;
    const glm::dquat q = glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
    const glm::dvec3 t(normal(random), normal(random), normal(random));
    return glm::translate(glm::dmat4(1.0), reach * t) * glm::mat4_cast(q);
}

} // namespace hachure::geometry::reference
