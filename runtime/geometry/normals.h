#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace hachure::geometry {

/// How much a triangle counts in the normal of one of its corners. `a` and `b` are the edges that leave the corner.
enum class NormalWeight : std::uint8_t {
    area,       ///< |a x b| / 2
    angle,      ///< the angle between a and b
    angle_area, ///< their product (Sorman & Hult 2005)
    max1999,    ///< sin(a, b) / (|a| |b|) (N. Max 1999): exact on a sphere, and the best on clean smooth meshes
};

/// The normal of a vertex that no triangle with an area uses.
inline constexpr glm::vec3 default_normal{0.0f, 1.0f, 0.0f};

struct NormalOptions {
    NormalWeight weight = NormalWeight::max1999;
    /// Radians in [0, pi]. Two triangles that share an edge and whose normals differ by more than this do not share
    /// their normals there; pi smooths over every edge.
    float crease_angle = std::numbers::pi_v<float>;
};

/// A mesh with normals. The first vertices are those of the input in their order; a vertex on a crease is repeated at
/// the end, once for every further normal that it has.
struct ComputedNormals {
    std::vector<glm::vec3> normals;     ///< unit
    std::vector<std::uint32_t> source;  ///< per vertex: the vertex of the input to take every other attribute from
    std::vector<std::uint32_t> indices; ///< 3 per triangle, in the order of the input
};

/// Normals of the surface, whatever seams its vertices have: vertices at one place are taken together. Around a vertex,
/// triangles share one normal when they are connected through edges that are no creases, so that shading is continuous
/// across every edge but creases. Triangles without an area contribute nothing.
[[nodiscard]] ComputedNormals vertex_normals(std::span<const glm::vec3> positions,
                                             std::span<const std::uint32_t> indices, const NormalOptions& options = {});

/// Smooth normals of a mesh that deforms, every frame: like `vertex_normals` with a crease angle of pi, with no
/// allocation after the first run on a mesh of that size.
struct SmoothNormalsJob {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> indices; ///< 3 per triangle
    /// Per vertex: the vertex that stands for it, as `weld_positions` gives it for the rest pose. Vertices that are to
    /// keep their own normal stand for themselves.
    std::span<const std::uint32_t> weld;
    NormalWeight weight = NormalWeight::max1999;
    std::span<glm::vec3> normals; ///< out: unit, one per vertex

    /// Asserts that sizes agree and indices are in range.
    void validate() const;
    void run();

    std::vector<glm::dvec3> sums{}; ///< scratch, kept from run to run
};

} // namespace hachure::geometry
