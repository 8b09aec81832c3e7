// Where lines touch, meet and cross: one node each.

#include <hachure/runtime/geometry/link_ridges_near.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hachure::geometry {
namespace {

/// Junctions with no more than this between them are one, pixels.
constexpr float shortest_link = 2.0f;

/// What is nearer along a line is no other place of it.
constexpr float apart_along = 4.0f;

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

} // namespace hachure::geometry
