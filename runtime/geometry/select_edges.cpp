#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/choose_edge.h>
#include <hachure/runtime/geometry/select_edges.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

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

void SelectEdgesJob::run_faces(std::size_t first, std::size_t last) {
    for (std::size_t face = first; face < last; ++face) front[face] = glm::dot(planes[face], eye) > 0.0f;
}

std::size_t SelectEdgesJob::run_edges(std::size_t first, std::size_t last) {
    const ChooseEdge choose{wanted, closed};
    const auto is_front = [this](std::uint32_t face) { return front[face] != 0; };
    std::size_t end = first;
    const auto add = [&](std::size_t i, std::uint32_t features_of_edge) {
        const std::uint32_t kinds = choose(features_of_edge, facing(edges[i], is_front), edges[i].face1 == no_face);
        chosen[end] = {static_cast<std::uint32_t>(i), kinds};
        end += (kinds & line_kinds) != 0 ? 1 : 0;
    };
    auto feature = std::ranges::lower_bound(features, first, {}, &ChosenEdge::edge);
    for (std::size_t i = first; i < last;) {
        // Between two features only silhouettes are looked for.
        const std::size_t next = feature != features.end() ? std::min<std::size_t>(feature->edge, last) : last;
        for (; i < next; ++i) add(i, 0);
        if (i == last) break;
        add(i++, (feature++)->kinds);
    }
    return end - first;
}

void SelectEdgesJob::run() {
    run_faces(0, planes.size());
    count = run_edges(0, edges.size());
}

void select_in_parallel(SelectEdgesJob& job) {
    constexpr std::size_t chunk = 32768;
    const std::size_t faces = job.planes.size(), edges = job.edges.size();
    parallel_for((faces + chunk - 1) / chunk,
                 [&](std::size_t task) { job.run_faces(task * chunk, std::min(faces, (task + 1) * chunk)); });
    std::vector<std::size_t> counts((edges + chunk - 1) / chunk);
    parallel_for(counts.size(), [&](std::size_t task) {
        counts[task] = job.run_edges(task * chunk, std::min(edges, (task + 1) * chunk));
    });
    job.count = 0;
    for (std::size_t task = 0; task < counts.size(); ++task) {
        const std::span<ChosenEdge> part = job.chosen.subspan(task * chunk, counts[task]);
        std::ranges::copy(part, job.chosen.begin() + static_cast<std::ptrdiff_t>(job.count)); // never upwards
        job.count += counts[task];
    }
}

bool is_closed(std::span<const Edge> edges) {
    return std::ranges::none_of(
        edges, [](const Edge& edge) { return (edge.flags & (edge_border | edge_orientation_mismatch)) != 0; });
}

} // namespace hachure::geometry
