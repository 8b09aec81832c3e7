#pragma once

#include <hachure/runtime/geometry/edges.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace hachure {

/// Chooses the edges of a mesh that are drawn from an eye. One sweep over faces, one over edges, no allocation.
struct SelectEdgesJob {
    std::span<const geometry::Edge> edges;
    std::span<const glm::vec4> planes; ///< of every face, as geometry::face_planes gives them
    glm::vec4 eye{0.0f};               ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    bool silhouette = true;
    bool crease = true;
    bool border = true;
    float crease_angle = 0.9f; ///< radians between face normals
    bool closed = false;       ///< nothing behind a back face can be seen: creases between back faces are left out

    std::span<std::uint8_t> front;     ///< scratch, one per face
    std::span<std::uint32_t> selected; ///< out, room for one per edge; indices into `edges`, ascending
    std::size_t count = 0;             ///< out: how many were selected

    /// Asserts that the sizes fit and that the edges' faces exist.
    void validate() const;
    void run();
};

} // namespace hachure
