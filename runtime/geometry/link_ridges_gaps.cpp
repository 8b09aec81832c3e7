// Free ends go on to what they face.

#include <hachure/runtime/geometry/link_ridges_near.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hachure::geometry {
namespace {

/// An end faces what lies within 60 degrees of where it would go on.
constexpr float facing_cosine = 0.5f;

/// How much farther than the nearest an end may look at others: opposite arms of a crossing are 1.41 times as far
/// apart as those beside each other.
constexpr float past_nearest = 1.5f;

/// Over how many pixels behind an end its direction is measured.
constexpr float direction_length = 4.0f;

bool faces(const LinkRidgesJob::FreeEnd& end, glm::vec2 from, glm::vec2 to) {
    const glm::vec2 step = to - from;
    return glm::dot(end.ahead, step) >= facing_cosine * glm::length(step);
}

} // namespace

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

} // namespace hachure::geometry
