#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// The handles of a world: enough to make another world give out the same ones. A slot that is not in `free` and whose
/// generation is not used up (2^32 - 1) is alive.
struct EntityIds {
    std::vector<std::uint32_t>
        generations;                 ///< by slot: of the entity that lives there, or of the next one to live there
    std::vector<std::uint32_t> free; ///< slots to be given out, the last one first
};

namespace detail {

/// Which entities of a world live. An id is free, then reserved (given out, not yet alive), then alive, then free again
/// with the next generation.
class EntityTable {
public:
    /// A fresh id. It is not alive until `activate`.
    Entity reserve();

    /// Makes a reserved id alive.
    void activate(Entity entity);

    /// Ends a reserved or live id; handles to it are dead from now on.
    void release(Entity entity);

    bool alive(Entity entity) const {
        return entity.index < slots_.size() && slots_[entity.index].generation == entity.generation &&
               slots_[entity.index].row != no_row;
    }

    bool reserved(Entity entity) const {
        return entity.index < slots_.size() && slots_[entity.index].generation == entity.generation &&
               slots_[entity.index].row == no_row;
    }

    /// Every live entity, packed. Its order depends only on the calls made so far.
    std::span<const Entity> entities() const { return alive_; }

    EntityIds ids() const;

    /// Only when nothing is alive or reserved.
    void restore(const EntityIds& ids);

private:
    static constexpr std::uint32_t no_row = 0xffff'ffffu;

    struct Slot {
        std::uint32_t generation;
        std::uint32_t row; ///< where in alive_; no_row when reserved or free
    };

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    std::vector<Entity> alive_;
};

} // namespace detail
} // namespace hachure
