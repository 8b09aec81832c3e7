#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/storage/large_memory.h>
#include <hachure/runtime/ecs/storage/location.h>
#include <hachure/runtime/ecs/storage/row_index.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// The handles of a world: enough to make another world give out the same ones. A slot that is not in `free` and whose
/// generation is not used up (2^32 - 1) is alive.
struct EntityIds {
    std::vector<std::uint32_t> generations; ///< by slot: of the entity that lives there, or of the next to live there
    std::vector<std::uint32_t> free;        ///< slots to be given out, the last one first
};

namespace detail {

/// Which entities of a world live, and where their rows are. An id is free, then reserved (given out, not yet alive),
/// then alive, then free again with the next generation.
class EntityTable final : public RowIndex {
public:
    EntityTable() = default;
    EntityTable(const EntityTable&) = delete;
    EntityTable& operator=(const EntityTable&) = delete;
    ~EntityTable() override { release_slots(); }

    /// A fresh id. It is not alive until `activate`.
    Entity reserve() {
        if (promised_ > 0) keep_promises();
        if (next_free_ == none) return append();
        const std::uint32_t index = next_free_;
        next_free_ = slots_[index].state & index_mask;
        slots_[index].state = reserved_state;
        return {index, slots_[index].generation};
    }

    /// The same while other threads may be looking rows up: it moves no memory and writes nothing that they read.
    Entity promise() {
        if (next_free_ == none) return {count_ + promised_++, 1};
        const std::uint32_t index = next_free_;
        next_free_ = slots_[index].state & index_mask;
        slots_[index].state = reserved_state;
        return {index, slots_[index].generation};
    }

    /// Makes a reserved id alive, with its row at `at`.
    void activate(Entity entity, Location at) {
        if (promised_ > 0) keep_promises();
        HACHURE_ASSERT(reserved(entity), "only a reserved entity becomes alive");
        slots_[entity.index].state = at.packed();
        ++alive_;
    }

    /// The entity's row moved.
    void set_row(Entity entity, Location at) override { slots_[entity.index].state = at.packed(); }

    /// Ends a reserved or live id; handles to it are dead from now on.
    void release(Entity entity);

    /// The row of an entity; nowhere when it is not alive.
    Location find(Entity entity) const { return row_of(entity, slots_, count_); }

    /// The same for several; as many locations are written.
    void find(std::span<const Entity> entities, Location* rows) const {
        const Slot* const slots = slots_;
        const std::uint32_t count = count_;
        for (const Entity entity : entities) *rows++ = row_of(entity, slots, count);
    }

    /// Fetches from memory what `find` will read.
    void prefetch(Entity entity) const {
        if (entity.index < count_) __builtin_prefetch(&slots_[entity.index]);
    }

    bool alive(Entity entity) const { return static_cast<bool>(find(entity)); }

    bool reserved(Entity entity) const {
        if (entity.index >= count_ && entity.index - count_ < promised_) return entity.generation == 1;
        return entity.index < count_ && slots_[entity.index].generation == entity.generation &&
               slots_[entity.index].state == reserved_state;
    }

    /// How many are alive.
    std::size_t alive_count() const { return alive_; }

    /// An id that is reserved counts as alive.
    EntityIds ids() const;

    /// Only when nothing is alive or reserved. Afterwards the slots that `ids` says are alive are reserved: `f(Entity)`
    /// is called for each in order, and activates it.
    template <class F> void restore(const EntityIds& ids, F&& f) {
        for (const Entity entity : reset(ids)) f(entity);
    }

private:
    // A slot's state is its location's number while alive; otherwise the highest bit is set, and the others are the
    // next free slot, or all set for a reserved one. `none` ends the list of free slots.
    static constexpr std::uint32_t dead_bit = 0x8000'0000u;
    static constexpr std::uint32_t index_mask = 0x7fff'ffffu;
    static constexpr std::uint32_t reserved_state = 0xffff'ffffu;
    static constexpr std::uint32_t none = 0x7fff'fffeu;

    struct Slot {
        std::uint32_t state;
        std::uint32_t generation;
    };

    static Location row_of(Entity entity, const Slot* slots, std::uint32_t count) {
        // Handle and slot as one number each, or GCC takes handles apart in vector registers, at twice the price.
        static_assert(std::endian::native == std::endian::little);
        const auto bits = std::bit_cast<std::uint64_t>(entity);
        const auto index = static_cast<std::uint32_t>(bits);
        if (index >= count) return {};
        const auto slot = std::bit_cast<std::uint64_t>(slots[index]);
        return (slot ^ bits) >> 32 == 0 ? Location::unpack(static_cast<std::uint32_t>(slot)) : Location{};
    }
    Entity append() {
        if (count_ == capacity_) grow(count_ + 1);
        slots_[count_] = {.state = reserved_state, .generation = 1};
        return {count_++, 1};
    }
    void keep_promises();
    void grow(std::size_t slots);
    void release_slots();
    std::vector<Entity> reset(const EntityIds& ids);

    // Not a vector: large pages, as for the values that the slots lead to.
    Slot* slots_ = nullptr;
    std::uint32_t count_ = 0;
    std::uint32_t capacity_ = 0;
    std::uint32_t promised_ = 0; ///< ids behind count_ that are reserved and have no slot yet
    std::uint32_t next_free_ = none;
    std::size_t alive_ = 0;
};

} // namespace detail
} // namespace hachure
