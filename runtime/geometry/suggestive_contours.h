#pragma once

#include <hachure/runtime/geometry/surface_segment.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// What decides how strongly a suggestive contour is drawn. Weights rise from 0 to 1 over ranges, so that lines come
/// and go by fading and not at once.
struct SuggestiveOptions {
    /// Radians between normal and view, [0, pi / 2): where the surface is seen more from the front than that, lines
    /// are weak; they are full from `angle + angle_fade` on.
    float angle = 0.35f;
    float angle_fade = 0.25f;
    /// The derivative of radial curvature towards the eye, times the square of `feature_size`: below it lines are left
    /// out; they are full from (1 + fade) times that on.
    float derivative = 0.02f;
    float fade = 1.0f;
};

/// The size that derivatives of curvature are measured by: `fraction` times the middle edge length... of a mesh.
[[nodiscard]] float feature_size(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// Suggestive contours (DeCarlo et al. 2003; 2004): where the surface almost becomes a silhouette. With the view
/// vector v = eye - p, its part w in the tangent plane and the radial curvature k_r = II(w, w) / |w|^2, they are where
/// k_r = 0 and its derivative along w is positive, C(w, w, w) / |w|^3 - 2 cot(angle) t^2 with the radial torsion t;
/// on triangles that face the eye. II and C are quantities of vertices, k_r is linear over each triangle.
///
/// Ends over edges meet bit for bit; where a line stops within a triangle (its derivative gets too low) the end is
/// free.
struct SuggestiveContoursJob {
    std::span<const glm::vec3> positions{};
    std::span<const glm::vec3> normals{};     ///< as CurvatureJob took them
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    std::span<const std::uint32_t> weld{};    ///< as CurvatureJob took it
    std::span<const glm::vec2> curvatures{};  ///< as CurvatureJob gives them
    std::span<const glm::vec3> directions{};  ///< likewise
    std::span<const glm::vec4> derivatives{}; ///< as CurvatureDerivativeJob gives them
    glm::vec4 eye{0.0f};       ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    float feature_size = 1.0f; ///< metres, as the function gives it
    SuggestiveOptions options{};
    /// The triangles that can hold a line from any eye, ascending, as `suggestive_candidates` gives them; without any,
    /// all triangles are looked at.
    std::span<const std::uint32_t> candidates{};

    std::vector<SurfaceSegment> segments{}; ///< out, kept from run to run; by rising faces

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    struct Radial {
        float curvature, derivative, front; ///< the last: cosine between normal and view
    };
    std::vector<Radial> radial{};
};

/// The triangles that are not convex at all three vertices, nor concave at all: no others have k_r = 0 from any eye.
[[nodiscard]] std::vector<std::uint32_t> suggestive_candidates(std::span<const std::uint32_t> indices,
                                                               std::span<const std::uint32_t> weld,
                                                               std::span<const glm::vec2> curvatures);

} // namespace hachure::geometry
