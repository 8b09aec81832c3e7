#pragma once

#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/vertex_neighbours.h>
#include <hachure/systems/shade_strokes/shade_settings.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// Finds how much of their amplitude strokes keep on a mesh that is deformed, per vertex: the amplitude for the
/// curvature that there is now, over that for the rest pose's, where it is less. Both curvatures are by the same
/// method, so that its errors and what hard edges do to it are the same in both, and smoothed as those are that
/// amplitudes are laid by. Works on several threads, with the same bits on any number of them; allocates nothing after
/// the first run.
struct ShadeNarrowingJob {
    std::span<const glm::vec3> positions{};   ///< of the rest pose, finite; as long as they stay it is not looked at
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle, in range
    std::span<const glm::vec2> curvatures{};  ///< per vertex of the deformed mesh: k1, k2 with |k1| >= |k2|, 1/metre
    geometry::CurvatureMethod method = geometry::CurvatureMethod::one_ring; ///< what those are taken from
    ShadeSettings settings{};
    double size = 1.0; ///< of the model (ShadeMesh::size)

    std::vector<float> shares{}; ///< out: per vertex, in (0, 1]

    /// Asserts that sizes agree.
    void validate() const;
    void run();

    /// Kept from run to run.
    const glm::vec3* rest_of = nullptr;
    geometry::CurvatureMethod rest_by{};
    std::vector<std::uint32_t> weld{};
    geometry::VertexNeighbours neighbours{};
    std::vector<float> rest{}, now{}, next{}; ///< smoothed |k1|, by vertex that stands for others

private:
    void look_at_rest();
    void smooth(std::span<const glm::vec2> raw, std::vector<float>& values);
};

} // namespace hachure
