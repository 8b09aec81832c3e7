#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/edge_lengths.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure::geometry {
namespace {

std::uint32_t low_end(std::uint64_t edge) { return static_cast<std::uint32_t>(edge >> 32); }
std::uint32_t high_end(std::uint64_t edge) { return static_cast<std::uint32_t>(edge); }

} // namespace

void EdgeLengthsJob::validate() const {
    HACHURE_ASSERT(weld.size() == positions.size(), "one weld per vertex");
    HACHURE_ASSERT(relative.size() == positions.size(), "one length per vertex");
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(share >= 0.0 && share <= 1.0, "a share is between 0 and 1");
    HACHURE_ASSERT(std::ranges::all_of(indices, [&](std::uint32_t i) { return i < positions.size(); }),
                   "indices are in range");
    HACHURE_ASSERT(std::ranges::all_of(weld, [&](std::uint32_t i) { return i < positions.size(); }),
                   "welds are in range");
}

void EdgeLengthsJob::run() {
    find_edges();
    average();
    for (std::uint32_t ring = 0; ring < rings; ++ring) smooth();
    const double full = long_one();
    for (std::size_t v = 0; v < relative.size(); ++v) {
        const std::uint32_t place = weld[v];
        const bool known = counts[place] > 0 && full > 0.0;
        relative[v] = known ? static_cast<float>(std::min(lengths[place] / full, 1.0)) : 1.0f;
    }
}

/// An edge counts once, however many triangles share it.
void EdgeLengthsJob::find_edges() {
    edges.clear();
    areas.assign(positions.size(), 0.0);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const std::uint32_t corner[3] = {weld[indices[i]], weld[indices[i + 1]], weld[indices[i + 2]]};
        const glm::dvec3 a(positions[corner[0]]), b(positions[corner[1]]), c(positions[corner[2]]);
        const double third = glm::length(glm::cross(b - a, c - a)) / 6.0;
        for (int k = 0; k < 3; ++k) {
            areas[corner[k]] += third;
            const auto [low, high] = std::minmax(corner[k], corner[(k + 1) % 3]);
            if (low != high) edges.push_back(std::uint64_t{low} << 32 | high);
        }
    }
    std::ranges::sort(edges);
    edges.erase(std::ranges::unique(edges).begin(), edges.end());
}

void EdgeLengthsJob::average() {
    lengths.assign(positions.size(), 0.0);
    counts.assign(positions.size(), 0);
    for (const std::uint64_t edge : edges) {
        const std::uint32_t low = low_end(edge), high = high_end(edge);
        const double length = glm::distance(glm::dvec3(positions[low]), glm::dvec3(positions[high]));
        lengths[low] += length;
        lengths[high] += length;
        ++counts[low];
        ++counts[high];
    }
    for (std::size_t i = 0; i < lengths.size(); ++i)
        if (counts[i] > 0) lengths[i] /= counts[i];
}

void EdgeLengthsJob::smooth() {
    sums.assign(positions.size(), 0.0);
    for (const std::uint64_t edge : edges) {
        sums[low_end(edge)] += lengths[high_end(edge)];
        sums[high_end(edge)] += lengths[low_end(edge)];
    }
    for (std::size_t i = 0; i < lengths.size(); ++i)
        if (counts[i] > 0) lengths[i] = 0.5 * (lengths[i] + sums[i] / counts[i]);
}

/// By area and not by vertex, of which a finely tessellated part has most.
double EdgeLengthsJob::long_one() {
    order.clear();
    double area = 0.0;
    for (std::uint32_t i = 0; i < lengths.size(); ++i) {
        if (areas[i] <= 0.0) continue;
        order.push_back(i);
        area += areas[i];
    }
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return lengths[a] != lengths[b] ? lengths[a] < lengths[b] : a < b;
    });
    double below = 0.0;
    for (const std::uint32_t place : order) {
        below += areas[place];
        if (below >= share * area * (1.0 - 1e-9)) return lengths[place];
    }
    return 0.0;
}

} // namespace hachure::geometry
