#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// Connectivity of a triangle soup, shared by the edge table, the mesh inspection and the half-edge mesh.
namespace hachure::geometry {

/// The triangles of a mesh between places: vertices at one place are one.
struct WeldedTriangles {
    static constexpr std::uint32_t dropped = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> weld; ///< vertex -> first vertex at its place
    /// Per triangle of the input its three places, or three times `dropped`.
    std::vector<std::array<std::uint32_t, 3>> corners;
    std::vector<bool> has_back;   ///< per triangle: another one lies on it that faces the other way
    std::uint32_t degenerate = 0; ///< dropped: two corners at one place
    std::uint32_t duplicate = 0;  ///< dropped: the same places as an earlier triangle, with the same winding
    std::uint32_t backs = 0;      ///< the same places as an earlier triangle, with the other winding

    [[nodiscard]] bool kept(std::size_t face) const { return corners[face][0] != dropped; }
};

/// What to do with triangles that lie back to back with an earlier one.
enum class Backs : std::uint8_t { keep, drop };

[[nodiscard]] WeldedTriangles weld_triangles(std::span<const glm::vec3> positions,
                                             std::span<const std::uint32_t> indices, Backs backs);

/// One triangle's use of an edge.
struct EdgeUse {
    std::uint32_t high;     ///< the edge's higher vertex
    std::uint32_t corner;   ///< 3 * triangle + k: the edge runs from corner k to corner k + 1
    std::uint32_t backward; ///< 1 when it runs from the higher vertex to the lower

    [[nodiscard]] std::uint32_t face() const { return corner / 3; }
    [[nodiscard]] std::uint32_t end_corner() const { return corner % 3 == 2 ? corner - 2 : corner + 1; }
};

/// All uses of edges, grouped by edge. Grouping by the lower vertex is a counting sort, which keeps the order of the
/// file and with it the cache; the few uses at one vertex are then sorted by the other end.
class EdgeUses {
public:
    explicit EdgeUses(const WeldedTriangles& triangles);

    /// Calls `visit(low, span of its uses)` for every edge, by rising ends; uses are in the order of the triangles.
    template <class Visit> void each_edge(Visit&& visit) const {
        for (std::uint32_t low = 0; low + 1 < first_.size(); ++low) {
            for (std::size_t i = first_[low]; i < first_[low + 1];) {
                std::size_t end = i + 1;
                while (end < first_[low + 1] && uses_[end].high == uses_[i].high) ++end;
                visit(low, std::span<const EdgeUse>(uses_.data() + i, end - i));
                i = end;
            }
        }
    }

private:
    std::vector<std::size_t> first_; ///< per lower vertex, one more at the end
    std::vector<EdgeUse> uses_;
};

/// Disjoint sets of 0..n-1.
class UnionFind {
public:
    explicit UnionFind(std::size_t n) : parent_(n) {
        for (std::size_t i = 0; i < n; ++i) parent_[i] = static_cast<std::uint32_t>(i);
    }
    [[nodiscard]] std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// The lower root stays the root, so results do not depend on the order of joining.
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Whether a triangle between three places has a height under 1e-6 of its longest edge. Single precision leaves such a
/// triangle no trustworthy normal.
[[nodiscard]] bool is_sliver(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

} // namespace hachure::geometry
