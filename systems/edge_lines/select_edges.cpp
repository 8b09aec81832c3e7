#include <hachure/runtime/assert.h>
#include <hachure/systems/edge_lines/select_edges.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure {

using geometry::Edge;

void SelectEdgesJob::validate() const {
    HACHURE_ASSERT(front.size() == planes.size(), "one scratch byte per face");
    HACHURE_ASSERT(creases.size() == edges.size(), "one mark per edge");
    HACHURE_ASSERT(selected.size() >= edges.size(), "room for every edge");
    for (const Edge& edge : edges) {
        HACHURE_ASSERT(edge.face0 < planes.size(), "the first face of an edge exists");
        HACHURE_ASSERT(edge.face1 == geometry::no_face || edge.face1 < planes.size(),
                       "the second face exists or is none");
    }
}

void SelectEdgesJob::run() {
    for (std::size_t face = 0; face < planes.size(); ++face) front[face] = glm::dot(planes[face], eye) > 0.0f;

    const auto is_drawn = [&](std::size_t i) {
        const Edge& edge = edges[i];
        if (edge.face1 == geometry::no_face) return border;
        // Where the two faces disagree which side is the front, one of them is read the other way round.
        const bool mismatch = (edge.flags & geometry::edge_orientation_mismatch) != 0;
        const bool front0 = front[edge.face0] != 0;
        const bool front1 = (front[edge.face1] != 0) != mismatch;
        if (silhouette && front0 != front1) return true;
        return crease && creases[i] != 0 && !(closed && !front0 && !front1);
    };
    count = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        selected[count] = static_cast<std::uint32_t>(i);
        count += is_drawn(i) ? 1 : 0;
    }
}

} // namespace hachure
