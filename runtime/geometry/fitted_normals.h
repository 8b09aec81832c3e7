#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace hachure::geometry {

enum class FittedShape : std::uint8_t { ellipsoid, sphere, cylinder };

/// Where a surface lies and how far it reaches in which directions: the centre of its area, the axes of the covariance
/// of its points and the variances along them.
struct SurfaceMoments {
    glm::dvec3 center{0.0};
    glm::dmat3 axes{1.0};      ///< columns: orthonormal, by falling variance
    glm::dvec3 variances{1.0}; ///< m^2
};

/// Over the areas of the triangles; over the vertices where no triangle has an area. Of no vertices: the default.
[[nodiscard]] SurfaceMoments surface_moments(std::span<const glm::vec3> positions,
                                             std::span<const std::uint32_t> indices);

/// Normals of a simple shape that stands in for a surface: at every vertex, the normal of the shape of its family that
/// goes through it. The shape has the surface's centre; the ellipsoid's axes are as the square roots of the variances,
/// the cylinder's axis is that of the greatest one. A vertex on the centre or the axis keeps its own normal.
struct FittedNormalsJob {
    FittedShape shape = FittedShape::ellipsoid;
    std::span<const glm::vec3> positions{};   ///< finite
    std::span<const glm::vec3> normals{};     ///< unit, one per vertex
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle

    std::span<glm::vec3> fitted{}; ///< out: unit, one per vertex

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();
};

} // namespace hachure::geometry
