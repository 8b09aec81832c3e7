#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/deformed_bounds.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace hachure::geometry {
namespace {

/// A box around the eight corners as the joint moves them.
Bounds moved(const Bounds& bounds, const JointMatrix& joint) {
    Bounds result;
    for (int i = 0; i < 8; ++i) {
        const glm::vec4 corner(bounds.corner(i), 1.0f);
        result.include(
            glm::vec3(glm::dot(joint.row[0], corner), glm::dot(joint.row[1], corner), glm::dot(joint.row[2], corner)));
    }
    return result;
}

} // namespace

std::vector<Bounds> rest_joint_bounds(const SkinWeights& weights, std::span<const glm::vec3> rest_positions) {
    HACHURE_ASSERT(weights.vertex_count() == rest_positions.size(), "weights of every vertex");
    std::vector<Bounds> bounds(weights.palette_size());
    for (std::size_t v = 0; v < rest_positions.size(); ++v)
        for (std::size_t k = 0; k < weights.influences(); ++k)
            if (weights.weight(v, k) > 0.0f) bounds[weights.joint(v, k)].include(rest_positions[v]);
    return bounds;
}

Bounds deformed_bounds(std::span<const Bounds> joint_bounds, std::span<const JointMatrix> palette) {
    HACHURE_ASSERT(joint_bounds.size() == palette.size(), "one box per palette entry");
    Bounds bounds;
    for (std::size_t j = 0; j < palette.size(); ++j)
        if (!joint_bounds[j].empty()) bounds.include(moved(joint_bounds[j], palette[j]));
    if (bounds.empty()) return bounds;
    const glm::vec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    const glm::vec3 margin = 1e-5f * glm::max(bounds.extent(), farthest);
    return {bounds.low - margin, bounds.high + margin};
}

} // namespace hachure::geometry
