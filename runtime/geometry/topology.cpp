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

/// One of the triangles with some lowest vertex.
struct Candidate {
    std::uint32_t middle, high, face;
    bool turned; ///< the winding is low, high, middle

    [[nodiscard]] bool same_places(const Candidate& other) const {
        return middle == other.middle && high == other.high;
    }
};

/// Among triangles with the same places, drops all but the first of each winding, or but the first.
void drop_copies(std::span<const Candidate> copies, Backs backs, WeldedTriangles& triangles) {
    bool has_back = false;
    for (const Candidate& copy : copies.subspan(1)) {
        const bool is_back = copy.turned != copies[0].turned;
        const bool first_back = is_back && !has_back;
        has_back = has_back || is_back;
        ++(first_back ? triangles.backs : triangles.duplicate);
        if (first_back && backs == Backs::keep)
            triangles.has_back[copy.face] = true;
        else
            triangles.corners[copy.face].fill(WeldedTriangles::dropped);
    }
    triangles.has_back[copies[0].face] = has_back;
}

/// Triangles are compared within buckets of their lowest vertex.
void drop_all_copies(WeldedTriangles& triangles, Backs backs) {
    std::vector<std::size_t> first(triangles.weld.size() + 1, 0);
    for (std::size_t f = 0; f < triangles.corners.size(); ++f)
        if (triangles.kept(f)) ++first[std::ranges::min(triangles.corners[f]) + 1];
    sizes_to_starts(first);
    std::vector<Candidate> candidates(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        if (!triangles.kept(f)) continue;
        auto [a, b, c] = triangles.corners[f];
        while (a > b || a > c) std::tie(a, b, c) = std::tuple(b, c, a); // the lowest comes first
        candidates[next[a]++] = {std::min(b, c), std::max(b, c), static_cast<std::uint32_t>(f), b > c};
    }
    triangles.has_back.assign(triangles.corners.size(), false);
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
        const std::span bucket(candidates.data() + first[v], first[v + 1] - first[v]);
        sort_bucket(bucket, [](const Candidate& a, const Candidate& b) {
            return std::tie(a.middle, a.high) < std::tie(b.middle, b.high);
        });
        for (std::size_t i = 0; i < bucket.size();) {
            std::size_t end = i + 1;
            while (end < bucket.size() && bucket[end].same_places(bucket[i])) ++end;
            if (end - i > 1) drop_copies(bucket.subspan(i, end - i), backs, triangles);
            i = end;
        }
    }
}

} // namespace

WeldedTriangles weld_triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               Backs backs) {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(indices.size() < WeldedTriangles::dropped, "corners are counted in 32 bits");
    WeldedTriangles triangles;
    triangles.weld = weld_positions(positions);
    triangles.corners.resize(indices.size() / 3);
    for (std::size_t f = 0; f < triangles.corners.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            HACHURE_ASSERT(indices[3 * f + k] < positions.size(), "indices must be in range");
            triangles.corners[f][k] = triangles.weld[indices[3 * f + k]];
        }
    }
    drop_degenerate(triangles);
    drop_all_copies(triangles, backs);
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
