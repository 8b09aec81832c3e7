#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hachure::geometry {

/// What a joint does to the rest pose, for linear blending: an affine matrix, by rows, in a cache line of its own.
struct alignas(64) JointMatrix {
    glm::vec4 row[4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
};

/// The same for dual quaternions: p -> real and dual as a rigid motion (first `stretch`, then rotation, then
/// translation). The stretch is symmetric and holds scale, shear and mirroring (negative definite where the joint
/// mirrors), so that the rotation is a proper one.
struct alignas(64) JointMotion {
    glm::vec4 real{0, 0, 0, 1};     ///< unit quaternion x, y, z, w
    glm::vec4 dual{0, 0, 0, 0};     ///< translation * real / 2
    glm::vec4 stretch0{1, 1, 1, 0}; ///< xx, yy, zz of the stretch
    glm::vec4 stretch1{0, 0, 0, 0}; ///< xy, xz, yz
};

/// One matrix as a palette holds it. A matrix that is not finite, or has an element beyond 1e15, gives identity.
[[nodiscard]] JointMatrix to_joint_matrix(const glm::dmat4& matrix);

/// The polar decomposition of one matrix; also of matrices that flatten, mirror, or are zero. Bad ones give identity.
[[nodiscard]] JointMotion to_joint_motion(const glm::dmat4& matrix);

/// Makes a palette from a posed skeleton: out[j] = to_out * joints[j] * inverse_bind[j], in double, rounded once.
struct SkinPaletteJob {
    /// Per joint: from the joint's space to the world's, in float or in double: exactly one of the two is given.
    std::span<const glm::mat4> joints{};
    std::span<const glm::dmat4> joints_double{};
    /// Per joint: from the rest pose's space to the joint's at rest; empty for identities.
    std::span<const glm::mat4> inverse_bind{};
    /// From the world to the space wanted: identity, or for vertices in the space of the mesh's node the inverse of
    /// its world matrix.
    glm::dmat4 to_out{1.0};
    /// What happens to vertices that follow no joint: from the rest pose to the space wanted.
    glm::dmat4 unweighted{1.0};

    std::span<JointMatrix> palette{}; ///< out: one per joint and one more; or empty
    std::span<JointMotion> motions{}; ///< out: the same for dual quaternions; or empty
    std::uint32_t repaired = 0;       ///< out: joints whose matrix was not finite and was replaced by identity

    /// Asserts that sizes agree.
    void validate() const;
    void run();
};

} // namespace hachure::geometry
