#pragma once

#include <hachure/systems/shade_strokes/shade_chains.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure {

/// Which end of a chain.
enum class ChainSide : std::uint32_t { begin, end };

/// Changes chains so that all links stay sound: within chains, within cells, and of ends that wait to go on.
class ChainEditor {
public:
    explicit ChainEditor(ShadeChains& chains) : chains_(chains) {}

    /// A chain without segments. `general` and `normal` are unit.
    std::uint32_t begin_chain(std::uint64_t random, const glm::vec3& general, const glm::vec3& normal, float max_alpha);

    /// Goes on from node `tip`, the outermost of the chain on that side (any for its first segment), to node `next`.
    /// The segment has alpha 0.
    std::uint32_t grow(std::uint32_t chain, ChainSide side, std::uint32_t tip, std::uint32_t next, std::uint32_t cell,
                       float shade);

    /// Takes a segment away. What is left before and behind it are two chains, whose ends wait to go on into its cell;
    /// `heading` (unit) is the segment's direction. Nodes and chains that nothing uses any more go, too.
    void remove(std::uint32_t segment, const glm::vec3& heading);

    /// Makes one chain of two, where the end node of the first is the begin node of the second.
    void join(std::uint32_t first, std::uint32_t second);

    /// Frees a chain that has no segments.
    void drop_empty(std::uint32_t chain);

    void wait(std::uint32_t chain, ChainSide side, std::uint32_t cell, const glm::vec3& heading);
    void stop_waiting(std::uint32_t chain, ChainSide side);

    /// Says how narrow a segment is: what share of its area is left, in (0, 1]. Does not refresh its cell.
    void narrow(std::uint32_t segment, double share) {
        chains_.links[segment].shade = static_cast<float>(share * chains_.links[segment].laid);
    }

    void set_alpha(std::uint32_t segment, float alpha) {
        if (chains_.segments[segment].alpha != alpha) chains_.segments.edit(segment).alpha = alpha;
    }
    /// Sums what the segments of a cell deliver.
    void refresh(std::uint32_t cell);

    /// The outermost node of a chain that has segments.
    [[nodiscard]] std::uint32_t outer_node(std::uint32_t chain, ChainSide side) const;

private:
    void link_to_cell(std::uint32_t segment, std::uint32_t cell);
    void unlink_from_cell(std::uint32_t segment);
    void own_from(std::uint32_t segment, std::uint32_t chain);

    ShadeChains& chains_;
};

} // namespace hachure
