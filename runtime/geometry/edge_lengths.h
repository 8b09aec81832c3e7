#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// How long the edges are at each vertex of a mesh, relative to the long ones of that mesh: where a mesh is finely
/// tessellated there is detail (Lee et al. 2007, section 3.4). At each place the mean length of the edges that meet
/// there is taken, then `rings` times its mean with the mean of its neighbours, so that it does not jump from vertex to
/// vertex. It is 1 at the length that `share` of the surface's area does not exceed, and above. Vertices at one place
/// are one. Vertices without an edge are at 1, and so is a mesh without any area.
struct EdgeLengthsJob {
    std::span<const glm::vec3> positions{};   ///< finite
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    std::span<const std::uint32_t> weld{};    ///< per vertex: the one that stands for it, as `weld_positions` gives it
    double share = 0.95;                      ///< in [0, 1]
    std::uint32_t rings = 2;

    std::span<float> relative{}; ///< out: (0, 1], one per vertex

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    // Scratch, kept from run to run.
    std::vector<std::uint64_t> edges{};  ///< the lower end in the upper half; each edge once
    std::vector<std::uint32_t> counts{}; ///< edges by place
    std::vector<double> areas{}, lengths{}, sums{};
    std::vector<std::uint32_t> order{}; ///< places by length

private:
    void find_edges();
    void average();
    void smooth();
    [[nodiscard]] double long_one();
};

} // namespace hachure::geometry
