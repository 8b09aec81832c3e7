#include <hachure/runtime/ecs/storage/removal_log.h>
#include <hachure/runtime/ecs/storage/table.h>

#include <algorithm>

namespace hachure::detail {

std::vector<Entity> RemovalLog::since(TypeId component, Tick since) const {
    std::vector<Entity> result;
    for (auto run = std::ranges::upper_bound(runs_, since, {}, &Run::tick); run != runs_.end(); ++run) {
        if (run->table ? !run->table->has(component) : run->component != component) continue;
        const std::size_t end = run + 1 != runs_.end() ? (run + 1)->begin : entities_.size();
        result.insert(result.end(), entities_.begin() + run->begin, entities_.begin() + end);
    }
    return result;
}

void RemovalLog::forget_before(Tick tick) {
    const auto keep = std::ranges::lower_bound(runs_, tick, {}, &Run::tick);
    if (keep == runs_.begin()) return;
    const std::size_t gone = keep != runs_.end() ? keep->begin : entities_.size();
    entities_.erase_front(gone);
    runs_.erase(runs_.begin(), keep);
    for (Run& run : runs_) run.begin -= gone;
}

} // namespace hachure::detail
