#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/topology.h>
#include <hachure/runtime/geometry/weld.h>

#include <glm/geometric.hpp>

#include <tuple>

namespace hachure::geometry {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Sorts the few elements of a bucket; insertion sort beats std::sort there, and keeps the order of equal ones.
template <class T, class Less> void sort_bucket(std::span<T> bucket, Less less) {
    if (bucket.size() > 24) {
        std::stable_sort(bucket.begin(), bucket.end(), less);
        return;
    }
    for (std::size_t i = 1; i < bucket.size(); ++i) {
        const T value = bucket[i];
        std::size_t at = i;
        for (; at > 0 && less(value, bucket[at - 1]); --at) bucket[at] = bucket[at - 1];
        bucket[at] = value;
    }
}

/// Starts of the buckets from their sizes, `first` holding the size of bucket i in element i + 1.
void sizes_to_starts(std::vector<std::size_t>& first) {
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
}

void drop_degenerate(WeldedTriangles& triangles) {
    for (Corners& c : triangles.corners) {
        if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) continue;
        c.fill(WeldedTriangles::dropped);
        ++triangles.degenerate;
    }
}

/// Triangles are compared within buckets of their lowest vertex.
void drop_duplicate(WeldedTriangles& triangles) {
    struct Entry {
        std::uint32_t middle, high, face;
    };
    std::vector<std::size_t> first(triangles.weld.size() + 1, 0);
    for (std::size_t f = 0; f < triangles.corners.size(); ++f)
        if (triangles.kept(f)) ++first[std::ranges::min(triangles.corners[f]) + 1];
    sizes_to_starts(first);
    std::vector<Entry> entries(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        if (!triangles.kept(f)) continue;
        auto [a, b, c] = triangles.corners[f];
        const std::uint32_t low = std::min({a, b, c}), high = std::max({a, b, c});
        entries[next[low]++] = {a ^ b ^ c ^ low ^ high, high, static_cast<std::uint32_t>(f)};
    }
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
        const std::span bucket(entries.data() + first[v], first[v + 1] - first[v]);
        sort_bucket(bucket, [](const Entry& a, const Entry& b) {
            return std::tie(a.middle, a.high) < std::tie(b.middle, b.high);
        });
        for (std::size_t i = 1; i < bucket.size(); ++i) {
            if (bucket[i].middle != bucket[i - 1].middle || bucket[i].high != bucket[i - 1].high) continue;
            triangles.corners[bucket[i].face].fill(WeldedTriangles::dropped);
            ++triangles.duplicate;
        }
    }
}

} // namespace

WeldedTriangles weld_triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(indices.size() < WeldedTriangles::dropped, "corners are counted in 32 bits");
    WeldedTriangles triangles{weld_positions(positions), std::vector<Corners>(indices.size() / 3)};
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            HACHURE_ASSERT(indices[3 * f + k] < positions.size(), "indices must be in range");
            triangles.corners[f][k] = triangles.weld[indices[3 * f + k]];
        }
    }
    drop_degenerate(triangles);
    drop_duplicate(triangles);
    return triangles;
}

EdgeUses::EdgeUses(const WeldedTriangles& triangles) : first_(triangles.weld.size() + 1, 0) {
    const auto each_use = [&](auto&& use) {
        for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
            if (!triangles.kept(f)) continue;
            const Corners& c = triangles.corners[f];
            for (std::uint32_t k = 0; k < 3; ++k)
                use(c[k], c[k == 2 ? 0 : k + 1], static_cast<std::uint32_t>(3 * f + k));
        }
    };
    each_use([&](std::uint32_t from, std::uint32_t to, std::uint32_t) { ++first_[std::min(from, to) + 1]; });
    sizes_to_starts(first_);
    uses_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    each_use([&](std::uint32_t from, std::uint32_t to, std::uint32_t corner) {
        uses_[next[std::min(from, to)]++] = {std::max(from, to), corner, from > to ? 1u : 0u};
    });
    for (std::size_t v = 0; v + 1 < first_.size(); ++v)
        sort_bucket(std::span(uses_.data() + first_[v], first_[v + 1] - first_[v]),
                    [](const EdgeUse& a, const EdgeUse& b) { return a.high < b.high; });
}

bool is_sliver(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 u = glm::dvec3(b) - glm::dvec3(a), v = glm::dvec3(c) - glm::dvec3(a), w = v - u;
    const double longest2 = std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)});
    const glm::dvec3 n = glm::cross(u, v); // its length is height times longest edge
    return glm::dot(n, n) < 1e-12 * longest2 * longest2;
}

} // namespace hachure::geometry
