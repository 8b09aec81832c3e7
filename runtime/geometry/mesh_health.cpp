#include <hachure/runtime/geometry/mesh_health.h>
#include <hachure/runtime/geometry/topology.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t no_corner = 0xffffffffu;

/// Everything that one walk over the edges can tell.
struct Walk {
    explicit Walk(std::size_t corners) : fans(corners), across(corners, no_corner), open(corners / 3, false) {}

    UnionFind fans;                    ///< of corners: those connected through edges at their vertex
    std::vector<std::uint32_t> across; ///< per corner: 2 * triangle across the edge that starts there + mismatch
    std::vector<bool> open;            ///< per triangle: has an edge without exactly one neighbour
    std::vector<EdgeUse> border;
};

/// Whatever its direction, the corner of `use` at the lower end of its edge, or at the higher.
std::uint32_t corner_at(const EdgeUse& use, bool high) {
    return high == (use.backward != 0) ? use.corner : use.end_corner();
}

Walk walk_edges(const WeldedTriangles& triangles, MeshHealth& health) {
    Walk walk(triangles.corners.size() * 3);
    EdgeUses(triangles).each_edge([&](std::uint32_t, std::span<const EdgeUse> uses) {
        for (std::size_t i = 1; i < uses.size(); ++i)
            for (const bool high : {false, true}) walk.fans.join(corner_at(uses[0], high), corner_at(uses[i], high));
        if (uses.size() == 2) {
            const std::uint32_t mismatch = uses[0].backward == uses[1].backward ? 1 : 0;
            health.mismatched_edges += mismatch;
            walk.across[uses[0].corner] = 2 * uses[1].face() + mismatch;
            walk.across[uses[1].corner] = 2 * uses[0].face() + mismatch;
            return;
        }
        for (const EdgeUse& use : uses) walk.open[use.face()] = true;
        if (uses.size() == 1) walk.border.push_back(uses[0]);
        ++(uses.size() == 1 ? health.boundary_edges : health.non_manifold_edges);
    });
    return walk;
}

/// Counts places, and those among them where several fans of triangles touch.
void count_vertices(const WeldedTriangles& triangles, std::span<const std::uint32_t> indices, Walk& walk,
                    MeshHealth& health) {
    std::vector<bool> used(triangles.weld.size(), false);
    for (const std::uint32_t i : indices) used[triangles.weld[i]] = true;
    std::vector<std::uint8_t> fans(triangles.weld.size(), 0);
    for (std::uint32_t c = 0; c < indices.size(); ++c) {
        if (!triangles.kept(c / 3) || walk.fans.find(c) != c) continue;
        std::uint8_t& count = fans[triangles.corners[c / 3][c % 3]];
        count = static_cast<std::uint8_t>(std::min(count + 1, 2));
    }
    for (std::size_t v = 0; v < triangles.weld.size(); ++v) {
        if (triangles.weld[v] != v) continue;
        ++health.vertices;
        if (!used[v]) ++health.isolated_vertices;
        if (fans[v] > 1) ++health.non_manifold_vertices;
    }
}

/// A loop passes from one border edge to the next along the fan of triangles between them.
std::uint32_t count_holes(Walk& walk) {
    UnionFind loops(walk.across.size());
    for (const EdgeUse& use : walk.border) loops.join(walk.fans.find(use.corner), walk.fans.find(use.end_corner()));
    std::vector<bool> seen(walk.across.size(), false);
    std::uint32_t holes = 0;
    for (const EdgeUse& use : walk.border) {
        const std::uint32_t loop = loops.find(walk.fans.find(use.corner));
        if (!seen[loop]) ++holes;
        seen[loop] = true;
    }
    return holes;
}

std::uint32_t count_components(const WeldedTriangles& triangles) {
    UnionFind sets(triangles.weld.size());
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        if (!triangles.kept(f)) continue;
        sets.join(triangles.corners[f][0], triangles.corners[f][1]);
        sets.join(triangles.corners[f][0], triangles.corners[f][2]);
    }
    std::vector<bool> seen(triangles.weld.size(), false);
    std::uint32_t components = 0;
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        if (!triangles.kept(f)) continue;
        const std::uint32_t set = sets.find(triangles.corners[f][0]);
        if (!seen[set]) ++components;
        seen[set] = true;
    }
    return components;
}

struct ConnectedPiece {
    std::uint32_t sides[2] = {0, 0}; ///< triangles that agree with the first one, and those that do not
    bool orientable = true;
    bool closed = true;
    double volume = 0.0;     ///< six times, signed
    double volume_sum = 0.0; ///< of its parts without sign: the scale for rounding
};

/// Follows edges with two triangles from `start`; `side` holds 0 or 1 per visited triangle.
ConnectedPiece follow_piece(std::span<const glm::vec3> positions, const WeldedTriangles& triangles, const Walk& walk,
                            std::uint32_t start, std::vector<std::uint8_t>& side, std::vector<std::uint32_t>& queue) {
    constexpr std::uint8_t unvisited = 2;
    ConnectedPiece piece;
    const glm::dvec3 origin(positions[triangles.corners[start][0]]);
    side[start] = 0;
    queue.assign(1, start);
    while (!queue.empty()) {
        const std::uint32_t f = queue.back();
        queue.pop_back();
        ++piece.sides[side[f]];
        piece.closed = piece.closed && !walk.open[f];
        const auto& c = triangles.corners[f];
        const glm::dvec3 p0 = glm::dvec3(positions[c[0]]) - origin, p1 = glm::dvec3(positions[c[1]]) - origin,
                         p2 = glm::dvec3(positions[c[2]]) - origin;
        const double part = glm::dot(p0, glm::cross(p1, p2));
        piece.volume += part;
        piece.volume_sum += std::abs(part);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t link = walk.across[3 * f + k];
            if (link == no_corner) continue;
            const auto expected = static_cast<std::uint8_t>(side[f] ^ (link & 1));
            if (side[link / 2] == unvisited) {
                side[link / 2] = expected;
                queue.push_back(link / 2);
            } else if (side[link / 2] != expected) {
                piece.orientable = false;
            }
        }
    }
    return piece;
}

void check_orientation(std::span<const glm::vec3> positions, const WeldedTriangles& triangles, const Walk& walk,
                       MeshHealth& health) {
    std::vector<std::uint8_t> side(triangles.corners.size(), 2);
    std::vector<std::uint32_t> queue;
    for (std::uint32_t f = 0; f < side.size(); ++f) {
        if (!triangles.kept(f) || side[f] != 2) continue;
        const ConnectedPiece piece = follow_piece(positions, triangles, walk, f, side, queue);
        if (!piece.orientable) {
            ++health.non_orientable_pieces;
            continue;
        }
        health.flipped_triangles += std::min(piece.sides[0], piece.sides[1]);
        const bool consistent = piece.sides[1] == 0;
        if (piece.closed && consistent && piece.volume < -1e-7 * piece.volume_sum) ++health.inside_out_pieces;
    }
}

} // namespace

MeshHealth inspect(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    const WeldedTriangles triangles = weld_triangles(positions, indices, Backs::keep);
    MeshHealth health;
    health.triangles = static_cast<std::uint32_t>(triangles.corners.size());
    health.degenerate_triangles = triangles.degenerate;
    health.duplicate_triangles = triangles.duplicate;
    health.opposed_triangles = triangles.backs;
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        const auto& c = triangles.corners[f];
        if (triangles.kept(f) && is_sliver(positions[c[0]], positions[c[1]], positions[c[2]]))
            ++health.sliver_triangles;
    }
    Walk walk = walk_edges(triangles, health);
    count_vertices(triangles, indices, walk, health);
    health.holes = count_holes(walk);
    health.components = count_components(triangles);
    check_orientation(positions, triangles, walk, health);
    return health;
}

} // namespace hachure::geometry
