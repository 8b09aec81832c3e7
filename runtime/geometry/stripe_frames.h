#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Across which direction the stripes of a coordinate u lie, and how fast the normal turns that way, at the vertices of
/// a mesh that deforms, every frame: u is any coordinate that stays with the vertices, of a StripeMesh or from texture
/// coordinates. Where the normal turns evenly along that direction, it points to a light in direction l at
/// `u + atan2(dot(l, X), dot(l, n)) / kappa`.
///
/// Allocates nothing after the first run on a mesh of that size. Never NaN.
struct StripeFramesJob {
    std::span<const glm::vec3> positions{};
    std::span<const glm::vec3> normals{};     ///< unit, one per vertex
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    std::span<const float> coordinate{};      ///< u, one per vertex, finite
    /// As in StripeMesh, one per vertex, so that frames agree on both sides of a line where u jumps; or both empty.
    std::span<const std::uint32_t> stands_for{};
    std::span<const std::uint8_t> mirrored{};
    /// As in StripeMesh, one per vertex, or empty: X and kappa are then those of a surface with the normals that these
    /// make of `normals`.
    std::span<const glm::vec3> lean{};
    /// out, as many. xyz: those normals, unit. w: radians per metre that they turn towards X.
    std::span<glm::vec4> smooth_normals{};

    /// out, one per vertex. xyz: X, the unit tangent along which u grows fastest; any unit tangent where u is constant.
    /// w: kappa, radians that the normal turns towards X per unit of u: positive where the surface bulges, +-pi at one
    /// set per half turn, 0 where the surface is flat along X or u is constant.
    std::span<glm::vec4> frames{};

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    struct Sum {
        glm::dvec3 gradient; ///< of u, times the weight of the triangle
        double turning;      ///< of the normal towards the gradient, per metre, times the weight
        double steepness;    ///< length of the gradient, times the weight
        double weight;
    };
    std::vector<Sum> sums{};
};

} // namespace hachure::geometry
