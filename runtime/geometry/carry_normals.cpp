#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/blended_joint.h>
#include <hachure/runtime/geometry/carry_normals.h>

#include <glm/geometric.hpp>

#include <cstddef>

namespace hachure::geometry {

void CarryNormalsJob::validate() const {
    HACHURE_ASSERT(weights != nullptr && weights->vertex_count() == rest.size(), "weights of every vertex");
    HACHURE_ASSERT(carried.size() == rest.size(), "one element per vertex");
    const std::size_t entries = method == SkinMethod::linear ? palette.size() : motions.size();
    HACHURE_ASSERT(entries == weights->palette_size(), "a palette entry per joint and one more");
}

void CarryNormalsJob::run() {
    for (std::size_t v = 0; v < rest.size(); ++v) {
        const glm::dmat3 m =
            method == SkinMethod::linear ? blended_matrix(*weights, palette, v) : blended_motion(*weights, motions, v);
        const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
        glm::dvec3 normal = cofactors * glm::dvec3(rest[v]);
        if (glm::dot(m[0], cofactors[0]) < 0.0) normal = -normal; // mirrored: it still points outwards
        const double size = glm::length(normal),
                     scale = glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
        carried[v] = size > 1e-9 * scale ? glm::vec3(normal / size) : rest[v];
    }
}

} // namespace hachure::geometry
