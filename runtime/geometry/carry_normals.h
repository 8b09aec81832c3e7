#pragma once

#include <hachure/runtime/geometry/skin.h>

#include <glm/vec3.hpp>

#include <span>

namespace hachure::geometry {

/// Carries a field of normals of the rest pose, which need not be those of the surface, along with the joints, as
/// SkinJob does the surface's own: by the cofactors of the blended 3x3. One without a direction left stays.
struct CarryNormalsJob {
    SkinMethod method = SkinMethod::linear;
    std::span<const glm::vec3> rest{};      ///< unit
    const SkinWeights* weights = nullptr;   ///< of as many vertices; not owned
    std::span<const JointMatrix> palette{}; ///< for `linear`
    std::span<const JointMotion> motions{}; ///< for `dual_quaternion`

    std::span<glm::vec3> carried{}; ///< out: unit

    /// Asserts that sizes agree.
    void validate() const;
    void run();
};

} // namespace hachure::geometry
