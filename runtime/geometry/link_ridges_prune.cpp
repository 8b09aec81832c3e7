// What is too little to be drawn.

#include <hachure/runtime/geometry/link_ridges.h>

#include <algorithm>

namespace hachure::geometry {
namespace {

/// Shorter spurs are none.
constexpr float spur_pixels = 1.5f, spur_widths = 1.25f;

} // namespace

/// Whether a line is a spur: about as long as the line that it begins at is wide. It is what pixels at the rim of that
/// see of it.
bool LinkRidgesJob::is_spur(const Chain& chain) const {
    const std::uint32_t start = chain_node(chain, 0), end = chain_node(chain, chain.count);
    const float width = std::max(linked.nodes[start].point.width, linked.nodes[end].point.width);
    return !limits[linked.nodes[start].owner].spurs && (linked.degree[start] == 1) != (linked.degree[end] == 1) &&
           chain.length < spur_pixels + spur_widths * width;
}

/// Of spurs where a line goes on, none stays; where it ends in them, the longest goes on with it.
bool LinkRidgesJob::is_superfluous(std::uint32_t index) const {
    const Chain& chain = linked.chains.chains[index];
    if (!is_spur(chain)) return false;
    const std::uint32_t start = chain_node(chain, 0), end = chain_node(chain, chain.count);
    const std::uint32_t node = linked.degree[start] == 1 ? end : start;
    return spurs[node].count + 2 <= linked.degree[node] || spurs[node].longest != index;
}

void LinkRidgesJob::count_spurs() {
    spurs.assign(linked.nodes.size(), {});
    for (std::uint32_t i = 0; i < linked.chains.chains.size(); ++i) {
        const Chain& chain = linked.chains.chains[i];
        if (!is_spur(chain)) continue;
        for (const std::uint32_t node : {chain_node(chain, 0), chain_node(chain, chain.count)}) {
            Spurs& here = spurs[node];
            if (here.count++ == 0 || chain.length > linked.chains.chains[here.longest].length) here.longest = i;
        }
    }
}

/// Whether a line is left out for being short. What links two junctions stays: it is part of a longer line.
bool LinkRidgesJob::too_short(const Chain& chain) const {
    const std::uint32_t start = chain_node(chain, 0), end = chain_node(chain, chain.count);
    const bool linked_on = linked.degree[start] > 1 && linked.degree[end] > 1 && start != end;
    return !linked_on && chain.length < limits[linked.nodes[start].owner].min_length;
}

void LinkRidgesJob::remove_line(const Chain& chain) {
    for (std::uint32_t i = 0; i < chain.count; ++i) {
        SegmentEnds& segment = linked.segments[linked.order[chain.first + i].segment];
        segment.end = segment.start;
    }
}

void LinkRidgesJob::prune() {
    count_spurs();
    for (std::uint32_t i = 0; i < linked.chains.chains.size(); ++i)
        if (is_superfluous(i)) remove_line(linked.chains.chains[i]);
    remove_points();
    chain();
    for (const Chain& chain : linked.chains.chains)
        if (too_short(chain)) remove_line(chain);
    remove_points();
    chain();
}

} // namespace hachure::geometry
