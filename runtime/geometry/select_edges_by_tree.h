#pragma once

#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/line_kinds.h>
#include <hachure/runtime/geometry/plane_tree.h>

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// The tree that finds silhouettes among `edges`: its items are the edges with two faces.
[[nodiscard]] PlaneTree edge_tree(std::span<const Edge> edges, std::span<const glm::vec4> planes);

/// What SelectEdgesJob chooses, bit for bit, without looking at every edge: silhouettes come from a hierarchy, features
/// from their list. For a mesh that keeps its shape, or after `tree.refit(planes)`.
struct SelectEdgesByTreeJob {
    std::span<const Edge> edges;
    std::span<const glm::vec4> planes;    ///< of every face, as `face_planes` gives them
    std::span<const ChosenEdge> features; ///< as `feature_edges` gives them
    const PlaneTree* tree = nullptr;      ///< of these edges and planes
    glm::vec4 eye{0.0f};        ///< in the mesh's space: a place (w = 1) or a direction towards the eye (w = 0)
    std::uint32_t wanted = ~0u; ///< LineKind: which kinds are drawn
    bool closed = false;        ///< nothing behind a back face can be seen: features between back faces are left out

    std::vector<ChosenEdge> chosen{}; ///< out, kept from run to run; ascending

    /// Asserts that the tree is of the edges, and features are edges.
    void validate() const;
    void run();

    PlaneTree::Scratch scratch{}; ///< kept from run to run
};

} // namespace hachure::geometry
