#pragma once

#include <hachure/runtime/geometry/edges.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// Marks the edges whose faces meet at more than `crease_angle` (radians between their normals), one byte per edge.
/// Noise on dense surfaces makes single edges that sharp; they are left out: creases that hang together are kept when
/// they are `long_crease` times the size of the mesh (the diagonal of its bounds) in all, or when they are
/// `short_crease` times that size and have `min_crease_edges` edges.
[[nodiscard]] std::vector<std::uint8_t> find_creases(std::span<const glm::vec3> positions,
                                                     std::span<const geometry::Edge> edges,
                                                     std::span<const glm::vec4> planes, float crease_angle);
inline constexpr std::size_t min_crease_edges = 6;
inline constexpr float long_crease = 0.06f;
inline constexpr float short_crease = 0.01f;

/// Chooses the edges of a mesh that are drawn from an eye. One sweep over faces, one over edges, no allocation.
struct SelectEdgesJob {
    std::span<const geometry::Edge> edges;
    std::span<const glm::vec4> planes;     ///< of every face, as geometry::face_planes gives them
    std::span<const std::uint8_t> creases; ///< one per edge: not 0 where it is a crease, as find_creases gives them
    glm::vec4 eye{0.0f}; ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    bool silhouette = true;
    bool crease = true;
    bool border = true;
    bool closed = false; ///< nothing behind a back face can be seen: creases between back faces are left out

    std::span<std::uint8_t> front;     ///< scratch, one per face
    std::span<std::uint32_t> selected; ///< out, room for one per edge; indices into `edges`, ascending
    std::size_t count = 0;             ///< out: how many were selected

    /// Asserts that the sizes fit and that the edges' faces exist.
    void validate() const;
    void run();
};

} // namespace hachure
