#include <hachure/runtime/ecs/component_store.h>

#include <algorithm>

namespace hachure::detail {

std::span<const Entity> StoreBase::removed_since(Tick since) const {
    const auto first = std::upper_bound(removed_ticks_.begin(), removed_ticks_.end(), since);
    return std::span(removed_).subspan(static_cast<std::size_t>(first - removed_ticks_.begin()));
}

void StoreBase::forget_removed_before(Tick tick) {
    const auto last = std::lower_bound(removed_ticks_.begin(), removed_ticks_.end(), tick);
    removed_.erase(removed_.begin(), removed_.begin() + (last - removed_ticks_.begin()));
    removed_ticks_.erase(removed_ticks_.begin(), last);
}

void StoreBase::push_row(Entity entity, Tick now) {
    index_.set(entity.index, static_cast<std::uint32_t>(entities_.size()));
    entities_.push_back(entity);
    added_.push_back(now);
    changed_.push_back(now);
    last_changed_ = now;
}

void StoreBase::erase_row(std::uint32_t row, Tick now) {
    const Entity gone = entities_[row];
    const Entity last = entities_.back();
    index_.set(last.index, row);
    index_.clear(gone.index); // after the line above: the two are the same entity when the last row goes
    entities_[row] = last;
    added_[row] = added_.back();
    changed_[row] = changed_.back();
    entities_.pop_back();
    added_.pop_back();
    changed_.pop_back();
    removed_.push_back(gone);
    removed_ticks_.push_back(now);
    last_changed_ = now;
}

} // namespace hachure::detail
