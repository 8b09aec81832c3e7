#include <hachure/runtime/geometry/sliver_bridge.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t removed = 1u << 31; // flag of entries to erase

using EdgesOfSlivers = std::map<std::uint32_t, std::vector<std::size_t>>; // sliver -> entries, in order of triangles

/// The two ends of the longest edge of a triangle.
std::pair<std::uint32_t, std::uint32_t> longest_edge(std::span<const glm::vec3> positions,
                                                     const std::array<std::uint32_t, 3>& corners) {
    std::pair<std::uint32_t, std::uint32_t> longest;
    double longest2 = -1.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
        const glm::dvec3 d = glm::dvec3(positions[b]) - glm::dvec3(positions[a]);
        if (glm::dot(d, d) <= longest2) continue;
        longest2 = glm::dot(d, d);
        longest = {a, b};
    }
    return longest;
}

void order_faces(Edge& edge) {
    if (edge.face0 <= edge.face1) return;
    std::swap(edge.face0, edge.face1);
    // The direction is that of face0; the other one runs the other way unless they disagree.
    if (!(edge.flags & edge_orientation_mismatch)) std::swap(edge.v0, edge.v1);
}

/// Puts the triangle behind `through` (or nothing) in the place of `sliver` on one of its short edges.
void replace_face(Edge& edge, std::uint32_t sliver, std::uint32_t behind, const Edge& through) {
    const bool twisted = through.flags & edge_orientation_mismatch;
    if (edge.face1 == sliver) {
        edge.face1 = behind;
    } else {
        edge.face0 = behind;
        if (behind != no_face && twisted) std::swap(edge.v0, edge.v1);
    }
    if (behind != no_face && edge.face0 != no_face && edge.face1 != no_face && twisted)
        edge.flags ^= edge_orientation_mismatch;
    order_faces(edge);
    if (edge.face1 == no_face) edge.flags = edge_border;
    if (edge.face0 == no_face || edge.face0 == edge.face1) edge.flags = removed;
}

bool bridge(std::uint32_t sliver, std::pair<std::uint32_t, std::uint32_t> ends, EdgesOfSlivers& of,
            std::vector<Edge>& edges) {
    const std::vector<std::size_t> around = std::move(of[sliver]);
    const Edge* through = nullptr;
    for (const std::size_t e : around) {
        if (edges[e].flags & edge_non_manifold) return false;
        if (std::minmax(edges[e].v0, edges[e].v1) == std::minmax(ends.first, ends.second)) through = &edges[e];
    }
    if (!through || (through->flags & removed)) return false;
    const std::uint32_t behind = through->face0 == sliver ? through->face1 : through->face0;
    for (const std::size_t e : around) {
        if (&edges[e] == through || (edges[e].flags & removed)) continue;
        replace_face(edges[e], sliver, behind, *through);
        if (const auto next = of.find(behind); next != of.end()) next->second.push_back(e);
    }
    edges[static_cast<std::size_t>(through - edges.data())].flags = removed;
    return true;
}

} // namespace

std::uint32_t bridge_slivers(std::span<const glm::vec3> positions, const WeldedTriangles& triangles,
                             std::vector<Edge>& edges) {
    EdgesOfSlivers of;
    for (std::uint32_t f = 0; f < triangles.corners.size(); ++f) {
        const auto& c = triangles.corners[f];
        if (triangles.kept(f) && is_sliver(positions[c[0]], positions[c[1]], positions[c[2]])) of[f];
    }
    if (of.empty()) return 0;
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (const std::uint32_t face : {edges[e].face0, edges[e].face1})
            if (const auto sliver = of.find(face); sliver != of.end()) sliver->second.push_back(e);
    std::uint32_t bridged = 0;
    for (const auto& [face, around] : of)
        if (bridge(face, longest_edge(positions, triangles.corners[face]), of, edges)) ++bridged;
    std::erase_if(edges, [](const Edge& edge) { return (edge.flags & removed) != 0; });
    return bridged;
}

} // namespace hachure::geometry
