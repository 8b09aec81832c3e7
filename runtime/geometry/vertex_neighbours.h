#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Which vertices the triangles of a mesh join. Only topology: it stays while the mesh deforms.
struct VertexNeighbours {
    std::vector<std::uint32_t> first;     ///< per vertex, and one more: where its neighbours begin
    std::vector<std::uint32_t> neighbour; ///< each once, by rising numbers

    /// `indices`: 3 per triangle. `weld`, one per vertex: the vertex that stands for it, as `weld_positions` gives it;
    /// only those that stand for themselves have neighbours and are some. Corners at one place are not joined.
    /// Allocates nothing after the first run on a mesh of that size.
    void build(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> weld);

    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t vertex) const {
        return {neighbour.data() + first[vertex], neighbour.data() + first[vertex + 1]};
    }

    std::vector<std::uint32_t> begin{}, repeated{}; ///< scratch: as the fields above, before repeats go
};

} // namespace hachure::geometry
