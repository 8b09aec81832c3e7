#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/choose_edge.h>
#include <hachure/runtime/geometry/select_edges.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace hachure::geometry {

void SelectEdgesJob::validate() const {
    HACHURE_ASSERT(front.size() == planes.size(), "one scratch byte per face");
    HACHURE_ASSERT(chosen.size() >= edges.size(), "room for every edge");
    for (const Edge& edge : edges) {
        HACHURE_ASSERT(edge.face0 < planes.size(), "the first face of an edge exists");
        HACHURE_ASSERT(edge.face1 == no_face || edge.face1 < planes.size(), "the second face exists or is none");
    }
    HACHURE_ASSERT(std::ranges::all_of(features, [&](const ChosenEdge& f) { return f.edge < edges.size(); }),
                   "features are edges");
    HACHURE_ASSERT(std::ranges::is_sorted(features, {}, &ChosenEdge::edge), "features ascend");
}

void SelectEdgesJob::run() {
    for (std::size_t face = 0; face < planes.size(); ++face) front[face] = glm::dot(planes[face], eye) > 0.0f;

    const ChooseEdge choose{wanted, closed};
    const auto is_front = [this](std::uint32_t face) { return front[face] != 0; };
    std::size_t feature = 0;
    count = 0;
    for (std::size_t i = 0; i < edges.size();) {
        // Between two features only silhouettes are looked for.
        const std::size_t next = feature < features.size() ? features[feature].edge : edges.size();
        for (; i < next; ++i) {
            const std::uint32_t kinds = choose(0, facing(edges[i], is_front), edges[i].face1 == no_face);
            chosen[count] = {static_cast<std::uint32_t>(i), kinds};
            count += (kinds & line_kinds) != 0 ? 1 : 0;
        }
        if (i == edges.size()) break;
        const std::uint32_t kinds =
            choose(features[feature].kinds, facing(edges[i], is_front), edges[i].face1 == no_face);
        chosen[count] = {static_cast<std::uint32_t>(i), kinds};
        count += (kinds & line_kinds) != 0 ? 1 : 0;
        ++i;
        ++feature;
    }
}

bool is_closed(std::span<const Edge> edges) {
    return std::ranges::none_of(
        edges, [](const Edge& edge) { return (edge.flags & (edge_border | edge_orientation_mismatch)) != 0; });
}

} // namespace hachure::geometry
