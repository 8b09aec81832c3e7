#pragma once

#include <hachure/runtime/geometry/surface_segment.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// How strongly a suggestive contour is drawn. Weights rise from 0 to 1 over ranges, so that lines come and go by
/// fading, not at once.
struct SuggestiveOptions {
    /// Angle between normal and view in radians, [0, pi / 2): where it is less, the surface is seen too much from the
    /// front for lines; they are full from `angle + angle_fade` on.
    float angle = 0.35f;
    float angle_fade = 0.25f;
    /// The derivative of radial curvature towards the eye times the sine of that angle, in units of 1 / size^2: where
    /// it is less there are no lines; they are full from `derivative + derivative_fade` on.
    float derivative = 2.0f;
    float derivative_fade = 2.0f;
    float size = 1.0f; ///< metres: of the mesh (half the diagonal of its bounds, say)
};

/// Suggestive contours, where the surface almost becomes a silhouette (DeCarlo et al. 2003; 2004). With the view vector
/// v = eye - p and its part w in the tangent plane, the radial curvature is k_r = II(w, w) / |w|^2. They are where k_r
/// = 0 and its derivative along w is positive:
///
///     D_w k_r = C(w, w, w) / |w|^3 - 2 cot(angle) t^2,   t the radial torsion, angle between n and v
///
/// and the surface faces the eye. II and C belong to vertices; k_r sin^2 and D_w k_r sin are linear over triangles.
/// Where lines go on over an edge ends meet bit for bit; where one stops within a triangle its end is free. A vertex
/// with k_r = 0 counts as one with k_r < 0.
struct SuggestiveContoursJob {
    std::span<const glm::vec3> positions{};
    std::span<const glm::vec3> normals{};     ///< as CurvatureJob took them
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    std::span<const std::uint32_t> weld{};    ///< as CurvatureJob took it
    std::span<const glm::vec2> curvatures{};  ///< as CurvatureJob gives them
    std::span<const glm::vec3> directions{};  ///< likewise
    std::span<const glm::vec4> derivatives{}; ///< as CurvatureDerivativeJob gives them
    /// Optional: the triangles to look at, ascending, as `suggestive_candidates` gives them: no others can have a line.
    std::span<const std::uint32_t> candidates{};
    glm::vec4 eye{0.0f}; ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    SuggestiveOptions options{};

    std::vector<SurfaceSegment> segments{}; ///< out, kept from run to run; by rising faces

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    /// What the eye makes of a vertex; scratch, kept from run to run.
    struct Radial {
        float curvature;  ///< k_r sin^2
        float derivative; ///< D_w k_r sin
        float cosine;     ///< of the angle
    };
    std::vector<Radial> radial{};
};

/// The triangles that are not convex at all three corners, nor concave at all: no others have k_r = 0 from any eye.
[[nodiscard]] std::vector<std::uint32_t> suggestive_candidates(std::span<const std::uint32_t> indices,
                                                               std::span<const std::uint32_t> weld,
                                                               std::span<const glm::vec2> curvatures);

} // namespace hachure::geometry
