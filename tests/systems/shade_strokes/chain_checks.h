#pragma once

#include <hachure/tests/support/shade_rig.h>

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <vector>

namespace hachure::test {

inline bool is_on_triangle(const ShadeMesh& mesh, const SurfacePoint& point) {
    return point.triangle < mesh.sheets.triangle_of.size() && point.u >= 0.0f && point.v >= 0.0f &&
           point.u + point.v <= 1.0f + 1e-6f;
}

/// Everything that must hold of chains after any history.
inline void expect_sound(const ShadeMesh& mesh, const ShadeChains& chains) {
    std::set<std::uint32_t> nodes;
    std::map<std::uint32_t, std::vector<std::uint32_t>> of_cell;
    std::size_t segments = 0, live_chains = 0;
    for (std::uint32_t c = 0; c < chains.chains.all().size(); ++c) {
        const ShadeChain& chain = chains.chains[c];
        if (chain.first == no_slot) continue;
        ++live_chains;
        std::uint32_t previous = no_slot, last_node = no_slot;
        for (std::uint32_t s = chain.first; s != no_slot; s = chains.segments[s].after) {
            const ShadeSegment& segment = chains.segments[s];
            ASSERT_EQ(segment.chain, c);
            ASSERT_EQ(segment.before, previous);
            if (previous != no_slot) {
                ASSERT_EQ(segment.from, last_node);
            } else {
                nodes.insert(segment.from);
            }
            ASSERT_NE(segment.from, segment.to);
            ASSERT_GE(segment.alpha, 0.0f);
            ASSERT_LE(segment.alpha, chains.links[s].max_alpha);
            ASSERT_GT(chains.links[s].shade, 0.0f);
            ASSERT_TRUE(nodes.insert(segment.to).second) << "a node belongs to one place of one chain";
            of_cell[segment.cell].push_back(s);
            ++segments;
            last_node = segment.to;
            previous = s;
        }
        ASSERT_EQ(chain.last, previous);
    }
    EXPECT_EQ(segments, chains.segments.live());
    EXPECT_EQ(live_chains, chains.chains.live());
    EXPECT_EQ(nodes.size(), chains.nodes.live());
    for (std::uint32_t c = 0; c < chains.cells.size(); ++c) {
        std::size_t listed = 0;
        double delivered = 0.0;
        for (std::uint32_t s = chains.cells[c].first; s != no_slot; s = chains.links[s].cell_next, ++listed) {
            ASSERT_EQ(chains.segments[s].cell, c);
            delivered += double(chains.segments[s].alpha) * chains.links[s].shade;
        }
        ASSERT_EQ(listed, of_cell[c].size());
        ASSERT_NEAR(chains.cells[c].delivered, delivered, 1e-5);
        for (std::uint32_t e = chains.cells[c].ends; e != no_slot; e = chains.chains[e / 2].end[e % 2].next)
            ASSERT_EQ(chains.chains[e / 2].end[e % 2].cell, c);
    }
    for (const std::uint32_t n : nodes) {
        const ShadeNode& node = chains.nodes[n];
        ASSERT_TRUE(std::isfinite(node.amplitude) && node.amplitude >= 0.0f);
        for (const SurfacePoint& point : node.rib) ASSERT_TRUE(is_on_triangle(mesh, point));
    }
}

/// Bit for bit.
template <class T> bool same_bits(std::span<const T> a, std::span<const T> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

inline bool same_chains(const ShadeChains& a, const ShadeChains& b) {
    return same_bits(a.nodes.all(), b.nodes.all()) && same_bits(a.segments.all(), b.segments.all()) && a.born == b.born;
}

} // namespace hachure::test
