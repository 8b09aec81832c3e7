#pragma once

#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/line_kinds.h>

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hachure::geometry {

/// Chooses the edges of a mesh that are drawn from an eye: one sweep over faces, one over edges, no allocation.
///
/// A face is seen from the front when dot(plane, eye) > 0; one without an area never is. An edge is a silhouette when
/// exactly one of its faces is, where one of two that disagree about their sides is turned over.
struct SelectEdgesJob {
    std::span<const Edge> edges;
    std::span<const glm::vec4> planes;    ///< of every face, as `face_planes` gives them
    std::span<const ChosenEdge> features; ///< as `feature_edges` gives them
    glm::vec4 eye{0.0f};        ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    std::uint32_t wanted = ~0u; ///< LineKind: which kinds are drawn
    bool closed = false;        ///< nothing behind a back face can be seen: features between back faces are left out

    std::span<std::uint8_t> front; ///< scratch, one per face
    std::span<ChosenEdge> chosen;  ///< out, room for one per edge; ascending
    std::size_t count = 0;         ///< out: how many were chosen

    /// Asserts that the sizes fit and that the edges' faces exist.
    void validate() const;
    void run();

    /// Parts of `run`, each fit for a thread of its own: the faces and then the edges of a range. What a range of edges
    /// chooses begins at chosen[first]; returned is how many they are.
    void run_faces(std::size_t first, std::size_t last);
    [[nodiscard]] std::size_t run_edges(std::size_t first, std::size_t last);
};

/// `job.run()` on several threads, with the same result.
void select_in_parallel(SelectEdgesJob& job);

/// Whether nothing behind a back face can be seen: no edge is a border or has faces that disagree about their sides.
[[nodiscard]] bool is_closed(std::span<const Edge> edges);

} // namespace hachure::geometry
