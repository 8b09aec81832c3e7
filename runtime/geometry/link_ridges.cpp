#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/link_ridges.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t no_link = std::numeric_limits<std::uint32_t>::max();

/// An end faces what lies within 60 degrees of where it would go on.
constexpr float facing_cosine = 0.5f;

/// How long a line is that only one or two pixels saw.
constexpr float dot_length = 1.0f;

/// What they saw so near to a line is that line, pixels.
constexpr float beside_line = 1.5f;

/// How much farther than the nearest an end may look at others: opposite arms of a crossing are 1.41 times as far
/// apart as those beside each other.
constexpr float past_nearest = 1.5f;

/// Shorter spurs are none.
constexpr float spur_pixels = 1.5f, spur_widths = 1.25f;

/// Two lines nearer than this cross or touch: ridges side by side are more than a pixel apart.
constexpr float touch = 0.75f;

/// Junctions with no more than this between them are one, pixels.
constexpr float shortest_link = 2.0f;

/// What is nearer along a line is no other place of it.
constexpr float apart_along = 4.0f;

/// Over how many pixels behind an end its direction is measured.
constexpr float direction_length = 4.0f;

bool faces(const LinkRidgesJob::FreeEnd& end, glm::vec2 from, glm::vec2 to) {
    const glm::vec2 step = to - from;
    return glm::dot(end.ahead, step) >= facing_cosine * glm::length(step);
}

/// Over which pixels behind a crossing the direction of its arms is measured: nearer ones are bent by the other line.
constexpr float arm_begin = 1.5f, arm_end = 6.0f;

} // namespace

void LinkRidgesJob::MeetingPlace::add(glm::vec2 place, glm::vec2 direction) {
    const glm::vec2 normal(-direction.y, direction.x);
    xx += normal.x * normal.x;
    xy += normal.x * normal.y;
    yy += normal.y * normal.y;
    right += normal * glm::dot(normal, place);
    sum += place;
    count += 1.0f;
}

glm::vec2 LinkRidgesJob::MeetingPlace::solve() const {
    const float determinant = xx * yy - xy * xy;
    if (determinant < 0.05f * count) return sum / count;
    return glm::vec2(yy * right.x - xy * right.y, xx * right.y - xy * right.x) / determinant;
}

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

glm::vec2 LinkRidgesJob::direction_ahead(const Chain& chain, bool at_end) const {
    const auto place = [&](std::uint32_t i) {
        return linked.nodes[chain_node(chain, at_end ? chain.count - i : i)].point.place;
    };
    const glm::vec2 end = place(0);
    glm::vec2 behind = end;
    for (std::uint32_t i = 1; i <= chain.count && glm::distance(end, behind) < direction_length; ++i) behind = place(i);
    return glm::distance(end, behind) > 0.0f ? glm::normalize(end - behind) : glm::vec2(0.0f);
}

void LinkRidgesJob::find_free_ends() {
    free_ends.clear();
    for (const Chain& chain : linked.chains.chains) {
        for (const bool at_end : {false, true}) {
            const std::uint32_t node = chain_node(chain, at_end ? chain.count : 0);
            if (linked.degree[node] != 1) continue;
            const float reach = gap + gap_widths * linked.nodes[node].point.width;
            free_ends.push_back({.node = node, .ahead = direction_ahead(chain, at_end), .reach = reach});
        }
    }
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

template <class Visit> void LinkRidgesJob::each_near(const Grid& grid, glm::vec2 at, Visit&& visit) const {
    const glm::ivec2 middle((at - grid.origin) / grid.cell);
    for (int y = std::max(0, middle.y - 1); y <= std::min(grid.rows - 1, middle.y + 1); ++y) {
        for (int x = std::max(0, middle.x - 1); x <= std::min(grid.columns - 1, middle.x + 1); ++x) {
            const std::size_t cell =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(x);
            for (std::uint32_t i = cell_starts[cell]; i < cell_starts[cell + 1]; ++i) visit(cell_nodes[i]);
        }
    }
}

/// Where two lines touch, their nearest nodes become one, in which both are cut.
void LinkRidgesJob::merge_touching() {
    if (linked.nodes.empty()) return;
    place_nodes();
    const Grid grid = sort_into_grid(2.0f);
    merged.resize(linked.nodes.size());
    for (std::uint32_t i = 0; i < merged.size(); ++i) merged[i] = i;
    const auto nearest_of_others = [&](std::uint32_t node) {
        std::uint32_t best = no_link;
        float nearest = touch;
        each_near(grid, linked.nodes[node].point.place, [&](std::uint32_t other) {
            const NodePlace &a = places[node], &b = places[other];
            if (b.chain == no_link || linked.nodes[other].owner != linked.nodes[node].owner) return;
            const float along = std::abs(a.arc - b.arc), around = linked.chains.chains[a.chain].length - along;
            if (a.chain == b.chain && std::min(along, around) < apart_along) return;
            const float distance = glm::distance(linked.nodes[node].point.place, linked.nodes[other].point.place);
            if (distance >= nearest) return;
            nearest = distance;
            best = other;
        });
        return best;
    };
    bool any = false;
    for (std::uint32_t node = 0; node < linked.nodes.size(); ++node) {
        if (linked.degree[node] != 2) continue;
        const std::uint32_t other = nearest_of_others(node);
        // Each is the other's nearest: of a stretch along which lines touch, one place. Where they meet already, more
        // places near by would only be slivers.
        if (other == no_link || other < node || linked.degree[other] != 2 || nearest_of_others(other) != node) continue;
        merged[other] = node;
        any = true;
    }
    if (!any) return;
    for (SegmentEnds& segment : linked.segments) segment = {merged[segment.start], merged[segment.end]};
    chain();
}

/// visit(i, j, distance) for ends that face each other within reach of both, each two once.
template <class Visit> void LinkRidgesJob::each_facing(const Grid& grid, Visit&& visit) const {
    for (std::uint32_t i = 0; i < free_ends.size(); ++i) {
        const FreeEnd& end = free_ends[i];
        const RidgeNode& node = linked.nodes[end.node];
        each_near(grid, node.point.place, [&](std::uint32_t other) {
            const std::uint32_t j = end_of_node[other];
            if (j == no_link || j <= i || linked.nodes[other].owner != node.owner) return;
            const glm::vec2 there = linked.nodes[other].point.place;
            const float distance = glm::distance(node.point.place, there);
            if (distance > 2.0f * std::min(end.reach, free_ends[j].reach)) return;
            if (faces(end, node.point.place, there) && faces(free_ends[j], there, node.point.place))
                visit(i, j, distance);
        });
    }
}

/// Ends that face each other are of one cluster, which is named by the least of them; but none that looks past one much
/// nearer.
void LinkRidgesJob::cluster_ends(const Grid& grid) {
    end_of_node.assign(linked.nodes.size(), no_link);
    for (std::uint32_t i = 0; i < free_ends.size(); ++i) {
        free_ends[i].cluster = i;
        end_of_node[free_ends[i].node] = i;
    }
    each_facing(grid, [&](std::uint32_t i, std::uint32_t j, float distance) {
        free_ends[i].nearest = std::min(free_ends[i].nearest, distance);
        free_ends[j].nearest = std::min(free_ends[j].nearest, distance);
    });
    const auto root = [&](std::uint32_t i) {
        while (free_ends[i].cluster != i) i = free_ends[i].cluster;
        return i;
    };
    each_facing(grid, [&](std::uint32_t i, std::uint32_t j, float distance) {
        if (distance > past_nearest * std::min(free_ends[i].nearest, free_ends[j].nearest)) return;
        const std::uint32_t a = root(i), b = root(j);
        free_ends[std::max(a, b)].cluster = std::min(a, b);
    });
    for (std::uint32_t i = 0; i < free_ends.size(); ++i) free_ends[i].cluster = root(i);
    std::ranges::sort(free_ends, {}, [](const FreeEnd& end) { return std::pair(end.cluster, end.node); });
}

bool LinkRidgesJob::may_join(std::uint32_t a, std::uint32_t b) const {
    return may_join(linked.nodes[a].owner, linked.nodes[a].point.place, linked.nodes[b].point.place);
}

bool LinkRidgesJob::may_join(std::uint32_t owner, glm::vec2 a, glm::vec2 b) const {
    if (limits.empty() || !limits[owner].gaps) return true;
    const int steps = static_cast<int>(2.0f * glm::distance(a, b));
    for (int i = 1; i < steps; ++i) {
        const glm::vec2 place = glm::mix(a, b, static_cast<float>(i) / static_cast<float>(steps));
        const glm::ivec2 pixel =
            glm::clamp(glm::ivec2(place), glm::ivec2(0), glm::ivec2(image.width, image.height) - 1);
        const std::size_t at = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(pixel.x);
        const glm::vec4& shown = image.points[at];
        if (shown.w <= 0.0f || shown.z * sign <= 0.0f) return false;
        if (glm::length(glm::vec2(shown)) > 0.5f * image.directions[at].z) return false;
    }
    return true;
}

void LinkRidgesJob::join_cluster(std::span<const FreeEnd> ends) {
    MeetingPlace meeting;
    RidgeNode node{{}, {}, linked.nodes[ends[0].node].owner};
    const float share = 1.0f / static_cast<float>(ends.size());
    for (const FreeEnd& end : ends) {
        const LinePoint& point = linked.nodes[end.node].point;
        meeting.add(point.place, end.ahead);
        node.point.width += share * point.width;
        node.point.opacity += share * point.opacity;
    }
    const glm::vec2 middle = share * meeting.sum, place = meeting.solve();
    node.point.place = glm::distance(middle, place) <= ends[0].reach ? place : middle;
    for (const FreeEnd& end : ends)
        if (may_join(node.owner, linked.nodes[end.node].point.place, node.point.place))
            linked.segments.push_back({end.node, linked.nodes.size()});
    linked.nodes.push_back(node);
}

/// The nearest place of a line that the end faces, nearer than `nearest`; nothing where there is none.
std::uint32_t LinkRidgesJob::find_line_ahead(const Grid& grid, const FreeEnd& end, float nearest) const {
    const RidgeNode& node = linked.nodes[end.node];
    std::uint32_t best = no_link;
    each_near(grid, node.point.place, [&](std::uint32_t other) {
        const RidgeNode& there = linked.nodes[other];
        if (there.owner != node.owner || linked.degree[other] < 2) return;
        const NodePlace &own = places[end.node], &its = places[other];
        if (own.chain == its.chain && std::abs(own.arc - its.arc) < 3.0f * end.reach) return;
        const float distance = glm::distance(node.point.place, there.point.place);
        if (distance >= nearest || !faces(end, node.point.place, there.point.place)) return;
        nearest = distance;
        best = other;
    });
    return best;
}

/// To the line ahead, if there is one: a T. Returns whether there is.
bool LinkRidgesJob::join_line_ahead(const Grid& grid, const FreeEnd& end, float nearest) {
    const std::uint32_t node = find_line_ahead(grid, end, nearest);
    if (node == no_link || !may_join(end.node, node)) return false;
    linked.segments.push_back({end.node, node});
    return true;
}

/// Two ends that face each other become one line, unless another one passes between them: then both end at it.
void LinkRidgesJob::join_pair(const Grid& grid, const FreeEnd& a, const FreeEnd& b) {
    const float between = glm::distance(linked.nodes[a.node].point.place, linked.nodes[b.node].point.place);
    const bool a_joined = join_line_ahead(grid, a, std::min(a.reach, between));
    const bool b_joined = join_line_ahead(grid, b, std::min(b.reach, between));
    if (!a_joined && !b_joined && may_join(a.node, b.node)) linked.segments.push_back({a.node, b.node});
}

void LinkRidgesJob::close_gaps() {
    find_free_ends();
    if (free_ends.empty()) return;
    place_nodes();
    float reach = 0.0f;
    for (const FreeEnd& end : free_ends) reach = std::max(reach, end.reach);
    const Grid grid = sort_into_grid(std::max(2.0f * reach, 1.0f));
    cluster_ends(grid);
    for (std::size_t first = 0; first < free_ends.size();) {
        std::size_t last = first + 1;
        while (last < free_ends.size() && free_ends[last].cluster == free_ends[first].cluster) ++last;
        if (last - first == 1)
            static_cast<void>(join_line_ahead(grid, free_ends[first], free_ends[first].reach));
        else if (last - first == 2)
            join_pair(grid, free_ends[first], free_ends[first + 1]);
        else
            join_cluster(std::span(free_ends).subspan(first, last - first));
        first = last;
    }
}

/// Two junctions that all but coincide, as pixels see those of four lines, become one.
void LinkRidgesJob::contract_links() {
    bool any = false;
    merged.resize(linked.nodes.size());
    for (std::uint32_t i = 0; i < merged.size(); ++i) merged[i] = i;
    for (const Chain& chain : linked.chains.chains) {
        const std::uint32_t start = chain_node(chain, 0), end = chain_node(chain, chain.count);
        if (chain.length >= shortest_link || linked.degree[start] < 3 || linked.degree[end] < 3) continue;
        if (start == end || merged[start] != start || merged[end] != end) continue;
        linked.nodes[start].point.place = 0.5f * (linked.nodes[start].point.place + linked.nodes[end].point.place);
        for (std::uint32_t i = 1; i <= chain.count; ++i) merged[chain_node(chain, i)] = start;
        linked.degree[start] = 0; // no part of another contraction, so that the order of lines does not matter
        any = true;
    }
    if (!any) return;
    for (SegmentEnds& segment : linked.segments) segment = {merged[segment.start], merged[segment.end]};
    remove_points();
    chain();
}

/// Puts junctions of four lines and more where those would cross.
void LinkRidgesJob::place_crossings() {
    arms.clear();
    for (const Chain& chain : linked.chains.chains) {
        for (const bool at_end : {false, true}) {
            const std::uint32_t node = chain_node(chain, at_end ? chain.count : 0);
            if (linked.degree[node] < 4 || chain.length < arm_end) continue;
            const auto behind = [&](float distance) {
                glm::vec2 place = linked.nodes[node].point.place;
                for (std::uint32_t i = 1; i <= chain.count; ++i) {
                    if (glm::distance(place, linked.nodes[node].point.place) >= distance) break;
                    place = linked.nodes[chain_node(chain, at_end ? chain.count - i : i)].point.place;
                }
                return place;
            };
            const glm::vec2 near = behind(arm_begin), far = behind(arm_end);
            if (near != far) arms.push_back({node, near, glm::normalize(near - far)});
        }
    }
    if (arms.empty()) return;
    std::ranges::sort(arms, {}, [](const Arm& arm) { return std::tuple(arm.node, arm.place.x, arm.place.y); });
    for (std::size_t first = 0; first < arms.size();) {
        MeetingPlace meeting;
        const std::uint32_t node = arms[first].node;
        for (; first < arms.size() && arms[first].node == node; ++first)
            meeting.add(arms[first].place, arms[first].direction);
        glm::vec2& place = linked.nodes[node].point.place;
        if (meeting.count < 4.0f) continue;
        if (const glm::vec2 better = meeting.solve(); glm::distance(place, better) < arm_begin) place = better;
    }
    chain(); // anew, as lengths have changed
}

/// Takes out segments from a node to itself.
void LinkRidgesJob::remove_points() {
    std::erase_if(linked.segments, [](const SegmentEnds& segment) { return segment.start == segment.end; });
}

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
