#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/sliver_bridge.h>
#include <hachure/runtime/geometry/topology.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

Edge make_edge(std::uint32_t low, const EdgeUse& a, const EdgeUse* b) {
    Edge edge{low, a.high, a.face(), no_face, 0};
    if (a.backward) std::swap(edge.v0, edge.v1);
    if (!b) {
        edge.flags = edge_border;
    } else {
        edge.face1 = b->face();
        if (a.backward == b->backward) edge.flags = edge_orientation_mismatch;
    }
    return edge;
}

/// Three triangles or more. Where only two of them are one-sided, the others are fins on the surface of these two.
void add_non_manifold(std::uint32_t low, std::span<const EdgeUse> uses, const WeldedTriangles& triangles,
                      std::vector<Edge>& edges) {
    const EdgeUse* one_sided[2] = {nullptr, nullptr};
    std::size_t count = 0;
    for (const EdgeUse& use : uses)
        if (!triangles.has_back[use.face()] && count++ < 2) one_sided[count - 1] = &use;
    const std::size_t first_new = edges.size();
    if (count == 2)
        edges.push_back(make_edge(low, *one_sided[0], one_sided[1]));
    else
        for (const EdgeUse& other : uses.subspan(1)) edges.push_back(make_edge(low, uses[0], &other));
    for (std::size_t e = first_new; e < edges.size(); ++e) edges[e].flags |= edge_non_manifold;
}

} // namespace

EdgeTable build_edge_table(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    const WeldedTriangles triangles = weld_triangles(positions, indices, Backs::drop);
    EdgeTable table;
    table.dropped_degenerate = triangles.degenerate;
    table.dropped_duplicate = triangles.duplicate + triangles.backs;
    table.edges.reserve(indices.size() / 2 + 16); // Euler: a closed mesh has three edges for two triangles
    EdgeUses(triangles).each_edge([&](std::uint32_t low, std::span<const EdgeUse> uses) {
        if (uses.size() > 2)
            add_non_manifold(low, uses, triangles, table.edges);
        else
            table.edges.push_back(make_edge(low, uses[0], uses.size() == 2 ? &uses[1] : nullptr));
    });
    table.bridged_slivers = bridge_slivers(positions, triangles, table.edges);
    return table;
}

void face_planes(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                 std::span<glm::vec4> planes) {
    HACHURE_ASSERT(indices.size() == planes.size() * 3, "one plane per triangle");
    for (std::size_t f = 0; f < planes.size(); ++f) {
        // In double, products of floats neither round nor underflow, so small triangles keep their planes.
        const glm::dvec3 a(positions[indices[3 * f]]), b(positions[indices[3 * f + 1]]),
            c(positions[indices[3 * f + 2]]);
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double length = std::sqrt(glm::dot(n, n));
        planes[f] = length > 0.0 ? glm::vec4(glm::dvec4(n / length, -glm::dot(n / length, (a + b + c) / 3.0)))
                                 : glm::vec4(0.0f);
    }
}

void face_planes_in_parallel(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                             std::span<glm::vec4> planes) {
    constexpr std::size_t chunk = 16384;
    parallel_for((planes.size() + chunk - 1) / chunk, [&](std::size_t task) {
        const std::size_t first = task * chunk, count = std::min(chunk, planes.size() - first);
        face_planes(positions, indices.subspan(3 * first, 3 * count), planes.subspan(first, count));
    });
}

} // namespace hachure::geometry
