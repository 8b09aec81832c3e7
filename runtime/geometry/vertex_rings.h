#pragma once

#include <hachure/runtime/geometry/vertex_neighbours.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Gathers the vertices around one, ring by ring: ring n holds those that n edges lead to and no fewer. A stamp per
/// vertex says which were met already, so that nothing is to be cleared between two vertices. One object per thread.
class VertexRings {
public:
    static constexpr std::size_t most_vertices = 1024; ///< a ring that would exceed this is cut

    /// For meshes of so many vertices. Allocates nothing when that is as before.
    void resize(std::size_t vertices) {
        if (stamp_.size() == vertices) return;
        stamp_.assign(vertices, 0);
        found_.resize(most_vertices + most_of_one + 1);
        round_ = 0;
    }

    /// Forgets what was found and begins with ring 0, the vertex itself.
    void start(std::uint32_t vertex) {
        if (++round_ == 0) {
            std::ranges::fill(stamp_, 0u);
            round_ = 1;
        }
        stamp_[vertex] = round_;
        found_[0] = vertex;
        ring_ = 0;
        first_ = size_ = 1;
    }

    /// Adds one ring; false when there is none.
    bool grow(const VertexNeighbours& neighbours) {
        const std::size_t begin = ring_, end = size_;
        for (std::size_t i = begin; i < end && size_ < most_vertices; ++i) visit(neighbours.of(found_[i]));
        ring_ = end;
        if (end == 1) first_ = size_;
        return size_ > end;
    }

    void grow(const VertexNeighbours& neighbours, std::size_t rings) {
        for (std::size_t i = 0; i < rings; ++i) grow(neighbours);
    }

    [[nodiscard]] std::span<const std::uint32_t> vertices() const { return {found_.data(), size_}; }
    [[nodiscard]] std::span<const std::uint32_t> first_ring() const { return vertices().subspan(1, first_ - 1); }
    [[nodiscard]] std::span<const std::uint32_t> last_ring() const { return vertices().subspan(ring_); }

private:
    static constexpr std::size_t most_of_one = 128; // of hubs with more neighbours, some all around

    /// No branch: about every second vertex was met before, which no processor foresees.
    void visit(std::span<const std::uint32_t> vertices) {
        const std::size_t step = 1 + vertices.size() / most_of_one;
        for (std::size_t k = 0; k < vertices.size(); k += step) {
            const std::uint32_t vertex = vertices[k];
            found_[size_] = vertex;
            size_ += stamp_[vertex] != round_ ? 1 : 0;
            stamp_[vertex] = round_;
        }
    }

    std::vector<std::uint32_t> stamp_, found_;
    std::size_t first_ = 0, ring_ = 0, size_ = 0; ///< where the first ring ends, the last one begins and ends
    std::uint32_t round_ = 0;
};

} // namespace hachure::geometry
