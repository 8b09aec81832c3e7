#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/storage/entity_table.h>

#include <algorithm>
#include <limits>
#include <span>
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

void EntityTable::grow(std::size_t slots) {
    constexpr std::size_t smallest = 256;
    HACHURE_ASSERT(slots < none, "a world holds fewer than 2^31 - 2 entities");
    const std::size_t capacity = std::min<std::size_t>(std::max({smallest, slots, 2 * std::size_t{capacity_}}), none);
    auto* larger = reinterpret_cast<Slot*>(allocate_large(capacity * sizeof(Slot)));
    std::copy_n(slots_, count_, larger);
    release_slots();
    slots_ = larger;
    capacity_ = static_cast<std::uint32_t>(capacity);
}

void EntityTable::release_slots() {
    if (slots_) release_large(reinterpret_cast<std::byte*>(slots_), capacity_ * sizeof(Slot));
}

void EntityTable::keep_promises() {
    for (; promised_ > 0; --promised_) append();
}

void EntityTable::release(Entity entity) {
    if (promised_ > 0) keep_promises();
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
    result.generations.reserve(count_);
    for (const Slot& slot : std::span(slots_, count_)) result.generations.push_back(slot.generation);
    result.generations.resize(count_ + promised_, 1);
    for (std::uint32_t index = next_free_; index != none; index = slots_[index].state & index_mask)
        result.free.push_back(index);
    std::ranges::reverse(result.free);
    return result;
}

std::vector<Entity> EntityTable::reset(const EntityIds& ids) {
    HACHURE_ASSERT(alive_ == 0, "handles are restored into an empty world");
    if (ids.generations.size() > capacity_) grow(ids.generations.size());
    count_ = promised_ = 0;
    for (const std::uint32_t generation : ids.generations)
        slots_[count_++] = {.state = reserved_state, .generation = generation};
    next_free_ = none;
    for (const std::uint32_t index : ids.free) {
        slots_[index].state = dead_bit | next_free_;
        next_free_ = index;
    }
    std::vector<Entity> live;
    for (std::uint32_t index = 0; index < count_; ++index)
        if (slots_[index].state == reserved_state && slots_[index].generation != last_generation)
            live.push_back({index, slots_[index].generation});
    return live;
}

} // namespace detail
} // namespace hachure
