#include <hachure/runtime/geometry/blended_joint.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace hachure::geometry {

glm::dmat3 blended_matrix(const SkinWeights& weights, std::span<const JointMatrix> palette, std::size_t vertex) {
    glm::dmat3 rows(0.0);
    for (std::size_t k = 0; k < weights.influences(); ++k) {
        const JointMatrix& joint = palette[weights.joint(vertex, k)];
        const double weight = weights.weight(vertex, k);
        for (int r = 0; r < 3; ++r) rows[r] += weight * glm::dvec3(joint.row[r]);
    }
    return glm::transpose(rows);
}

glm::dmat3 blended_motion(const SkinWeights& weights, std::span<const JointMotion> motions, std::size_t vertex) {
    const glm::dvec4 first(motions[weights.joint(vertex, 0)].real);
    glm::dvec4 real(0.0), diagonal(0.0), mixed(0.0);
    for (std::size_t k = 0; k < weights.influences(); ++k) {
        const JointMotion& joint = motions[weights.joint(vertex, k)];
        const double weight = weights.weight(vertex, k);
        const glm::dvec4 own(joint.real);
        real += glm::dot(own, first) < 0.0 ? -weight * own : weight * own;
        diagonal += weight * glm::dvec4(joint.stretch0);
        mixed += weight * glm::dvec4(joint.stretch1);
    }
    real = glm::normalize(real);
    const glm::dmat3 stretch(diagonal.x, mixed.x, mixed.y, mixed.x, diagonal.y, mixed.z, mixed.y, mixed.z, diagonal.z);
    return glm::mat3_cast(glm::dquat(real.w, real.x, real.y, real.z)) * stretch;
}

} // namespace hachure::geometry
