#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/choose_edge.h>
#include <hachure/runtime/geometry/select_edges_by_tree.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace hachure::geometry {

PlaneTree edge_tree(std::span<const Edge> edges, std::span<const glm::vec4> planes) {
    std::vector<std::uint32_t> items;
    items.reserve(2 * edges.size());
    for (const Edge& edge : edges) {
        items.push_back(edge.face0);
        const bool mismatch = (edge.flags & edge_orientation_mismatch) != 0;
        items.push_back(edge.face1 == no_face ? PlaneTree::left_out : edge.face1 | (mismatch ? PlaneTree::flip : 0u));
    }
    return {planes, items, 2};
}

void SelectEdgesByTreeJob::validate() const {
    HACHURE_ASSERT(tree != nullptr && tree->size() == edges.size() && tree->per_item() == 2, "the tree of these edges");
    HACHURE_ASSERT(std::ranges::all_of(features, [&](const ChosenEdge& f) { return f.edge < edges.size(); }),
                   "features are edges");
    HACHURE_ASSERT(std::ranges::is_sorted(features, {}, &ChosenEdge::edge), "features ascend");
}

void SelectEdgesByTreeJob::run() {
    chosen.clear();
    const ChooseEdge choose{wanted, closed};
    std::size_t next = 0;
    const auto add_feature = [&](const ChosenEdge& feature) {
        const Edge& edge = edges[feature.edge];
        const bool border = edge.face1 == no_face;
        const auto front = [&](std::uint32_t face) { return glm::dot(planes[face], eye) > 0.0f; };
        const std::uint32_t kinds = choose(feature.kinds, facing(edge, front), border);
        if ((kinds & line_kinds) != 0) chosen.push_back({feature.edge, kinds});
    };
    const auto add_features_below = [&](std::uint32_t edge) {
        while (next < features.size() && features[next].edge < edge) add_feature(features[next++]);
    };
    if ((wanted & line_silhouette) != 0) {
        tree->query(eye, scratch, [&](std::uint32_t edge, bool front) {
            add_features_below(edge);
            if (next < features.size() && features[next].edge == edge) return;
            chosen.push_back({edge, line_silhouette | (front ? line_front0 : line_front1)});
        });
    }
    add_features_below(no_face);
}

} // namespace hachure::geometry
