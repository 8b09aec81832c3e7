#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/entity_table.h>

#include <limits>

namespace hachure {

std::string to_string(Entity entity) {
    if (!entity) return "null";
    return std::to_string(entity.index) + 'v' + std::to_string(entity.generation);
}

namespace detail {

Entity EntityTable::reserve() {
    if (!free_.empty()) {
        const std::uint32_t index = free_.back();
        free_.pop_back();
        return {index, slots_[index].generation};
    }
    HACHURE_ASSERT(slots_.size() < no_row, "a world holds fewer than 2^32 - 1 entities");
    slots_.push_back({1, no_row});
    return {static_cast<std::uint32_t>(slots_.size() - 1), 1};
}

void EntityTable::activate(Entity entity) {
    HACHURE_ASSERT(reserved(entity), "only a reserved entity becomes alive");
    slots_[entity.index].row = static_cast<std::uint32_t>(alive_.size());
    alive_.push_back(entity);
}

void EntityTable::release(Entity entity) {
    HACHURE_ASSERT(alive(entity) || reserved(entity), "an entity ends once");
    Slot& slot = slots_[entity.index];
    if (slot.row != no_row) {
        const Entity last = alive_.back();
        alive_[slot.row] = last;
        slots_[last.index].row = slot.row;
        alive_.pop_back();
        slot.row = no_row;
    }
    // A slot whose generations are used up is never given out again, so a handle can never come back to life.
    if (++slot.generation != std::numeric_limits<std::uint32_t>::max()) free_.push_back(entity.index);
}

EntityIds EntityTable::ids() const {
    EntityIds result{{}, free_};
    for (const Slot& slot : slots_) result.generations.push_back(slot.generation);
    return result;
}

void EntityTable::restore(const EntityIds& ids) {
    HACHURE_ASSERT(alive_.empty(), "handles are restored into an empty world");
    slots_.clear();
    for (const std::uint32_t generation : ids.generations) slots_.push_back({generation, 0});
    free_ = ids.free;
    for (const std::uint32_t index : free_) slots_[index].row = no_row;
    for (std::uint32_t index = 0; index < slots_.size(); ++index) {
        Slot& slot = slots_[index];
        if (slot.generation == std::numeric_limits<std::uint32_t>::max()) slot.row = no_row;
        if (slot.row == no_row) continue;
        slot.row = static_cast<std::uint32_t>(alive_.size());
        alive_.push_back({index, slot.generation});
    }
}

} // namespace detail
} // namespace hachure
