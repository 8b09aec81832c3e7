#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Normals of a surface with its details smoothed away: they diffuse over the surface, whatever its triangles, which
/// keeps what is large against `radius`. Solves
///
///     (M + radius^2 S) N' = M N
///
/// an implicit Euler step of the heat equation with areas of vertices M and the cotangent stiffness S (Desbrun et al.
/// 1999), by conjugate gradients. Vertices at one place share their normal. Borders reflect. Triangles without an area
/// are left out; a vertex without any other keeps its normal, as one whose normals cancel out does.
struct DiffusedNormalsJob {
    std::span<const glm::vec3> positions{};   ///< finite
    std::span<const glm::vec3> normals{};     ///< unit, one per vertex
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle
    std::span<const std::uint32_t> weld{};    ///< per vertex: the one that stands for it, as `weld_positions` gives it
    double radius = 0.0;                      ///< metres, >= 0; 0 only averages at each place
    double tolerance = 1e-6;                  ///< of the residual, relative to that of no normals at all
    std::uint32_t max_steps = 2000;           ///< of the solver

    std::span<glm::vec3> diffused{}; ///< out: unit, one per vertex; may not overlap an input
    std::uint32_t steps = 0;         ///< out: that the solver took

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    // Scratch, kept from run to run.
    struct Triangle {
        std::uint32_t corner[3]; ///< places
        double weight[3];        ///< half the cotangent at each corner: of the edge opposite to it
    };
    std::vector<Triangle> triangles{};
    std::vector<double> areas{};    ///< by place; 0 where nothing is to be solved
    std::vector<double> diagonal{}; ///< of the matrix
    std::vector<glm::dvec3> solution{}, residual{}, direction{}, product{};

private:
    void assemble();
    void multiply();
    void solve();
};

} // namespace hachure::geometry
