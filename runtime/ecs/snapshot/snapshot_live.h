#pragma once

#include <hachure/runtime/ecs/snapshot/snapshot_bytes.h>
#include <hachure/runtime/ecs/world.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace hachure::detail {

/// The live entities of a world or of a snapshot, in order of slots. Their places in this order are what a snapshot
/// calls them by.
class LiveEntities {
public:
    static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

    /// Asserts when an entity is reserved and not yet alive.
    explicit LiveEntities(const World& world);

    /// Reads what `write` wrote. Throws Error for ids that no world has.
    explicit LiveEntities(ByteReader& in);

    void write(ByteWriter& out) const;

    std::uint32_t count() const { return static_cast<std::uint32_t>(entities.size()); }

    EntityIds ids;
    std::vector<Entity> entities;
    std::vector<std::uint32_t> place; ///< by slot; nowhere for those that are free

private:
    void find_live();
};

} // namespace hachure::detail
