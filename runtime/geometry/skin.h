#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/instruction_set.h>
#include <hachure/runtime/geometry/skin_palette.h>
#include <hachure/runtime/geometry/skin_weights.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace hachure::geometry {

enum class SkinMethod : std::uint8_t {
    linear,          ///< blends matrices (LBS): cheapest; loses volume in bends and twists
    dual_quaternion, ///< blends rigid motions (DQS, Kavan et al. 2008), after blending stretches: keeps the radius
};

/// Vertices [first, first + count) of a mesh; all by default.
struct VertexRange {
    std::size_t first = 0;
    std::size_t count = std::numeric_limits<std::size_t>::max(); ///< cut at the end of the mesh
};

/// Deforms vertices of a mesh by the joints that they follow. Results do not depend on how a mesh is cut into ranges:
/// several threads may each run a job over a range of their own (see `skin_in_parallel`). Outputs may not overlap
/// inputs. Allocates nothing.
///
/// Normals take the cofactors of the blended 3x3, which is right for scale and shear and stays defined where a joint
/// flattens; where it mirrors they still point outwards (glTF turns the winding there). A normal that has no direction
/// left (a collapse) stays the rest pose's. Tangents are transported
/// by the 3x3 and made perpendicular to the normal; their w turns where the mesh is mirrored. Nothing is ever NaN.
struct SkinJob {
    SkinMethod method = SkinMethod::linear;
    std::span<const glm::vec3> rest_positions{}; ///< finite
    std::span<const glm::vec3> rest_normals{};   ///< unit; or empty, as `normals` then is
    std::span<const glm::vec4> rest_tangents{};  ///< xyz unit, w = +-1; or empty. Needs normals
    const SkinWeights* weights = nullptr;        ///< of as many vertices; not owned
    std::span<const JointMatrix> palette{};      ///< `weights->palette_size()` entries, finite; for `linear`
    std::span<const JointMotion> motions{};      ///< the same for `dual_quaternion`
    VertexRange range{};                         ///< which vertices to deform
    InstructionSet instructions = best_instruction_set();

    std::span<glm::vec3> positions{}; ///< out: one per vertex of the mesh; those outside the range stay untouched
    std::span<glm::vec3> normals{};   ///< out: unit, one per vertex, or empty
    std::span<glm::vec4> tangents{};  ///< out: xyz unit and perpendicular to the normal, or empty
    Bounds bounds{};                  ///< out: of the positions of the range

    /// Asserts that sizes agree.
    void validate() const;
    void run();
};

/// Runs `job` over its range on all threads; `job.bounds` is that of all of it. The same result as `job.run()`.
void skin_in_parallel(SkinJob& job);

/// Carries principal curvatures and directions of the rest pose to the deformed mesh by the blended 3x3, without
/// looking at the deformed mesh: exact where the weights are constant (the curvature tensor is transported through
/// stretch and mirroring), wrong by the angle that varying weights add in a joint's bend: see docs/deformation.md.
struct CarryCurvatureJob {
    SkinMethod method = SkinMethod::linear;
    std::span<const glm::vec3> rest_normals{};
    std::span<const glm::vec2> rest_curvatures{}; ///< k1, k2 of `CurvatureJob` on the rest pose
    std::span<const glm::vec3> rest_directions{}; ///< unit, of k1
    const SkinWeights* weights = nullptr;         ///< not owned
    std::span<const JointMatrix> palette{};       ///< for `linear`
    std::span<const JointMotion> motions{};       ///< for `dual_quaternion`
    VertexRange range{};

    std::span<glm::vec2> curvatures{}; ///< out: k1, k2 with |k1| >= |k2|, one per vertex of the mesh
    std::span<glm::vec3> directions{}; ///< out: unit, of k1, perpendicular to the normal that SkinJob gives

    /// Asserts that sizes agree.
    void validate() const;
    void run();
};

} // namespace hachure::geometry
