#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/entity_table.h>

#include <algorithm>
#include <limits>
#include <string>

namespace hachure {

std::string to_string(Entity entity) {
    if (!entity) return "null";
    return std::to_string(entity.index) + 'v' + std::to_string(entity.generation);
}

namespace detail {
namespace {

constexpr std::uint32_t last_generation = std::numeric_limits<std::uint32_t>::max();

} // namespace

Entity EntityTable::append() {
    HACHURE_ASSERT(slots_.size() < none, "a world holds fewer than 2^31 - 2 entities");
    slots_.push_back({1, reserved_state});
    return {static_cast<std::uint32_t>(slots_.size() - 1), 1};
}

void EntityTable::activate(Entity entity, Location at) {
    HACHURE_ASSERT(reserved(entity), "only a reserved entity becomes alive");
    slots_[entity.index].state = at.packed();
    ++alive_;
}

void EntityTable::release(Entity entity) {
    HACHURE_ASSERT(alive(entity) || reserved(entity), "an entity ends once");
    Slot& slot = slots_[entity.index];
    if (slot.state != reserved_state) --alive_;
    slot.state = reserved_state;
    // A slot whose generations are used up is never given out again, so a handle can never come back to life.
    if (++slot.generation == last_generation) return;
    slot.state = dead_bit | next_free_;
    next_free_ = entity.index;
}

EntityIds EntityTable::ids() const {
    EntityIds result;
    result.generations.reserve(slots_.size());
    for (const Slot& slot : slots_) result.generations.push_back(slot.generation);
    for (std::uint32_t index = next_free_; index != none; index = slots_[index].state & index_mask)
        result.free.push_back(index);
    std::ranges::reverse(result.free);
    return result;
}

std::vector<Entity> EntityTable::reset(const EntityIds& ids) {
    HACHURE_ASSERT(alive_ == 0, "handles are restored into an empty world");
    slots_.clear();
    for (const std::uint32_t generation : ids.generations) slots_.push_back({generation, reserved_state});
    next_free_ = none;
    for (const std::uint32_t index : ids.free) {
        slots_[index].state = dead_bit | next_free_;
        next_free_ = index;
    }
    std::vector<Entity> live;
    for (std::uint32_t index = 0; index < slots_.size(); ++index)
        if (slots_[index].state == reserved_state && slots_[index].generation != last_generation)
            live.push_back({index, slots_[index].generation});
    return live;
}

} // namespace detail
} // namespace hachure
