#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// How curvature changes over the surface of a mesh that deforms, every frame (Rusinkiewicz 2004, section 4: the
/// derivative fitted to the curvature tensors at the corners of each triangle, averaged at its corners by Voronoi
/// areas). Allocates nothing after the first run on a mesh of that size.
///
/// The derivative C is symmetric in its three directions, so four numbers say all of it: in the frame of principal
/// directions e1 (`directions`) and e2 = cross(normal, e1) they are C(e1, e1, e1), C(e1, e1, e2), C(e1, e2, e2) and
/// C(e2, e2, e2), in 1/metre^2. Signs are those of CurvatureJob: positive where the surface bends more and more away
/// from its normal. Triangles without an area are left out; a vertex without any triangle has zeros. Never NaN.
struct CurvatureDerivativeJob {
    std::span<const glm::vec3> positions{};
    std::span<const glm::vec3> normals{};     ///< as CurvatureJob took them
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    std::span<const std::uint32_t> weld{};    ///< as CurvatureJob took it
    std::span<const glm::vec2> curvatures{};  ///< as CurvatureJob gives them
    std::span<const glm::vec3> directions{};  ///< likewise

    std::span<glm::vec4> derivatives{}; ///< out, one per vertex

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    struct Sum {
        double area, c[4]; ///< the tensor's elements in the vertex's frame, each times the area
    };
    std::vector<Sum> sums{};
};

} // namespace hachure::geometry
