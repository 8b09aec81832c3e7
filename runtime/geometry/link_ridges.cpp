#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/link_ridges_near.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace hachure::geometry {
namespace {

/// How long a line is that only one or two pixels saw.
constexpr float dot_length = 1.0f;

/// What they saw so near to a line is that line, pixels.
constexpr float beside_line = 1.5f;

} // namespace

void LinkRidgesJob::validate() const {
    HACHURE_ASSERT(std::ranges::all_of(segments,
                                       [&](const SegmentEnds& s) {
                                           return std::max(s.start, s.end) < nodes.size() && s.start != s.end;
                                       }),
                   "segments are between two nodes");
    HACHURE_ASSERT(gap >= 0.0f && gap_widths >= 0.0f, "lengths");
    HACHURE_ASSERT(limits.empty() ||
                       std::ranges::all_of(nodes, [&](const RidgeNode& node) { return node.owner < limits.size(); }),
                   "limits per owner");
}

void LinkRidgesJob::chain() {
    linked.degree.assign(linked.nodes.size(), 0);
    linked.lengths.clear();
    for (const SegmentEnds& segment : linked.segments) {
        ++linked.degree[segment.start];
        ++linked.degree[segment.end];
        linked.lengths.push_back(
            glm::distance(linked.nodes[segment.start].point.place, linked.nodes[segment.end].point.place));
    }
    linked.order.resize(linked.segments.size());
    linked.chains.ends = linked.segments;
    linked.chains.lengths = linked.lengths;
    linked.chains.order = linked.order;
    linked.chains.run();
}

/// Node `index` of a chain, which has one more than it has segments.
std::uint32_t LinkRidgesJob::chain_node(const Chain& chain, std::uint32_t index) const {
    const bool last = index == chain.count;
    const ChainedSegment& at = linked.order[chain.first + (last ? index - 1 : index)];
    const SegmentEnds& ends = linked.segments[at.segment];
    return static_cast<std::uint32_t>((at.reversed != 0) != last ? ends.end : ends.start);
}

void LinkRidgesJob::place_nodes() {
    places.assign(linked.nodes.size(), {no_link, 0.0f});
    for (std::uint32_t c = 0; c < linked.chains.chains.size(); ++c) {
        const Chain& chain = linked.chains.chains[c];
        for (std::uint32_t i = 0; i <= chain.count; ++i)
            places[chain_node(chain, i)] = {c, i < chain.count ? linked.order[chain.first + i].arc : chain.length};
    }
}

/// All nodes by the cell of a grid that they lie in.
LinkRidgesJob::Grid LinkRidgesJob::sort_into_grid(float cell) {
    Grid grid{.cell = cell};
    glm::vec2 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const RidgeNode& node : linked.nodes) {
        low = glm::min(low, node.point.place);
        high = glm::max(high, node.point.place);
    }
    grid.origin = low;
    grid.columns = static_cast<int>((high.x - low.x) / grid.cell) + 1;
    grid.rows = static_cast<int>((high.y - low.y) / grid.cell) + 1;
    const auto cell_of = [&](const RidgeNode& node) {
        const glm::ivec2 at((node.point.place - grid.origin) / grid.cell);
        return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(at.x);
    };
    cell_starts.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1, 0);
    for (const RidgeNode& node : linked.nodes) ++cell_starts[cell_of(node) + 1];
    for (std::size_t i = 1; i < cell_starts.size(); ++i) cell_starts[i] += cell_starts[i - 1];
    cell_nodes.resize(linked.nodes.size());
    for (std::size_t i = linked.nodes.size(); i-- > 0;)
        cell_nodes[--cell_starts[cell_of(linked.nodes[i]) + 1]] = static_cast<std::uint32_t>(i);
    // What was counted down is now the start of the cell one further.
    cell_starts.erase(cell_starts.begin());
    cell_starts.push_back(static_cast<std::uint32_t>(linked.nodes.size()));
    return grid;
}

/// Takes out segments from a node to itself.
void LinkRidgesJob::remove_points() {
    std::erase_if(linked.segments, [](const SegmentEnds& segment) { return segment.start == segment.end; });
}

void LinkRidgesJob::write_lines() {
    lines.clear();
    for (const Chain& chain : linked.chains.chains) {
        const std::uint32_t start = chain_node(chain, 0), end = chain_node(chain, chain.count);
        Polyline line{.first = static_cast<std::uint32_t>(lines.points.size()),
                      .count = chain.count + 1,
                      .owner = linked.nodes[start].owner,
                      .length = chain.length};
        line.closed = start == end && linked.degree[start] == 2;
        line.start_joined = !line.closed && linked.degree[start] > 1;
        line.end_joined = !line.closed && linked.degree[end] > 1;
        for (std::uint32_t i = 0; i <= chain.count; ++i)
            lines.points.push_back(linked.nodes[chain_node(chain, i)].point);
        lines.lines.push_back(line);
    }
}

/// Places that no piece leads to or from become short lines, unless they are beside a line. Such lines may then be
/// linked like others.
void LinkRidgesJob::lengthen_dots() {
    const auto count = static_cast<std::uint32_t>(linked.nodes.size());
    if (std::ranges::find(linked.degree, 0u) == linked.degree.end()) return;
    const Grid grid = sort_into_grid(2.0f);
    for (std::uint32_t dot = 0; dot < count; ++dot) {
        if (linked.degree[dot] != 0) continue;
        const RidgeNode node = linked.nodes[dot];
        bool beside = false;
        each_near(grid, node.point.place, [&](std::uint32_t other) {
            const RidgeNode& there = linked.nodes[other];
            // Of two dots that are one place to the eye, the first is drawn.
            const float room = linked.degree[other] > 0 ? beside_line : other < dot ? touch : 0.0f;
            beside = beside || (there.owner == node.owner && glm::distance(node.point.place, there.point.place) < room);
        });
        if (beside) continue;
        linked.segments.push_back({linked.nodes.size(), linked.nodes.size() + 1});
        for (const float side : {-0.5f, 0.5f}) {
            linked.nodes.push_back(node);
            linked.nodes.back().point.place += side * dot_length * node.tangent;
        }
    }
    chain();
}

void LinkRidgesJob::run() {
    linked.nodes.assign(nodes.begin(), nodes.end());
    linked.segments.assign(segments.begin(), segments.end());
    chain();
    lengthen_dots();
    merge_touching();
    close_gaps();
    chain();
    contract_links();
    place_crossings();
    if (!limits.empty()) prune();
    write_lines();
}

} // namespace hachure::geometry
