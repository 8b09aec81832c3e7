#pragma once

#include <hachure/runtime/ecs/snapshot/snapshot_bytes.h>
#include <hachure/runtime/ecs/world.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::detail {

/// A child and its parent, as places among the live entities in order of slots.
struct TreeLink {
    std::uint32_t child;
    std::uint32_t parent;
};

/// Writes who has which children. `place` gives the place of each live entity by its slot.
void write_tree(ByteWriter& out, const World& world, std::span<const std::uint32_t> place);

/// Reads it as the links to make, parents before children and children in order. Throws Error when it is no forest
/// over `entities` entities.
std::vector<TreeLink> read_tree(ByteReader& in, std::uint32_t entities);

} // namespace hachure::detail
