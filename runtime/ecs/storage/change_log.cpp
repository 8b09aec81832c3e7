#include <hachure/runtime/ecs/storage/change_log.h>

#include <algorithm>

namespace hachure::detail {

void ChangeLog::push(Entity entity, Tick now) {
    if (entries_.size() < limit()) {
        entries_.push_back({entity, now});
        return;
    }
    // Forget the older half: who asks that far back sweeps.
    const Tick until = entries_[entries_.size() / 2].tick;
    const auto keep = std::ranges::upper_bound(entries_, until, {}, &Entry::tick);
    entries_.erase(entries_.begin(), keep);
    complete_since_ = until;
    if (until < now) entries_.push_back({entity, now});
}

void ChangeLog::forget(Entity entity, Tick now) {
    constexpr std::size_t patience = 64;
    for (std::size_t i = entries_.size(), steps = 0; i-- > 0 && entries_[i].tick == now; ++steps) {
        if (steps == patience) return note_many(now);
        if (entries_[i].entity != entity) continue;
        entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i));
        return;
    }
}

std::span<const ChangeLog::Entry> ChangeLog::since(Tick since) const {
    const auto first = std::ranges::upper_bound(entries_, since, {}, &Entry::tick);
    return {first, entries_.end()};
}

} // namespace hachure::detail
