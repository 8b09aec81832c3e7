#include <hachure/runtime/geometry/vertex_neighbours.h>
#include <hachure/runtime/parallel.h>

#include <algorithm>
#include <cstddef>

namespace hachure::geometry {
namespace {

constexpr std::size_t neighbour_block = 8192; // vertices that one task works on

template <class Body> void for_each_vertex(std::size_t count, const Body& body) {
    parallel_for((count + neighbour_block - 1) / neighbour_block, [&](std::size_t block) {
        for (std::size_t v = block * neighbour_block; v < std::min(count, (block + 1) * neighbour_block); ++v) body(v);
    });
}

} // namespace

void VertexNeighbours::build(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> weld) {
    const std::size_t count = weld.size();
    // Two entries for each corner, sorted by vertex: counted, added up, filled in from the end of each vertex's part.
    begin.assign(count + 1, 0);
    for (const std::uint32_t i : indices) begin[weld[i]] += 2;
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : begin) entry = sum += entry;
    repeated.resize(sum);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = weld[indices[i + k]];
            repeated[--begin[v]] = weld[indices[i + (k + 1) % 3]];
            repeated[--begin[v]] = weld[indices[i + (k + 2) % 3]];
        }
    first.resize(count + 1);
    first[0] = 0;
    for_each_vertex(count, [&](std::size_t v) {
        const auto from = repeated.begin() + begin[v], to = repeated.begin() + begin[v + 1];
        std::sort(from, to);
        const auto others = std::remove(from, std::unique(from, to), static_cast<std::uint32_t>(v));
        first[v + 1] = static_cast<std::uint32_t>(others - from);
    });
    for (std::size_t v = 0; v < count; ++v) first[v + 1] += first[v];
    neighbour.resize(first[count]);
    for_each_vertex(count, [&](std::size_t v) {
        std::copy_n(repeated.begin() + begin[v], first[v + 1] - first[v], neighbour.begin() + first[v]);
    });
}

} // namespace hachure::geometry
