#include <hachure/runtime/ecs/query/query_filter.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace hachure::detail {
namespace {

/// Going to an entity of a list costs about as much as reading the ticks of so many rows in a sweep (`bench ecs`).
constexpr std::size_t step_of_list = 32;

/// How many changes the queues hold for a filter, or nothing when they don't reach back far enough.
std::optional<std::size_t> queued(const EntityStore& store, const ChangeFilter& filter) {
    std::size_t result = 0;
    for (const TypeId id : filter.components()) {
        const ComponentRecord* component = store.find_record(id);
        if (!component || component->log.last_changed() <= filter.since) continue;
        if (!component->log.complete_since(filter.since)) return std::nullopt;
        result += component->log.since(filter.since).size();
    }
    return result;
}

} // namespace

bool ChangeFilter::passes(const EntityStore& store, Entity entity) const {
    return std::ranges::any_of(components(), [&](TypeId id) {
        return (event == Event::changed ? store.changed(id, entity) : store.added(id, entity)) > since;
    });
}

bool FilteredWalk::begin(EntityStore& store, const ChangeFilters& filters, std::size_t rows, ChangeWalk how) {
    listed_ = false;
    candidates_.clear();
    count_ = 0;
    const ChangeFilter* shortest = nullptr;
    std::size_t length = how == ChangeWalk::queue ? std::numeric_limits<std::size_t>::max() : rows / step_of_list;
    for (const ChangeFilter& filter : filters.all()) {
        Filter& added = filters_[count_++];
        added = {filter.event, filter.since, 0, {}};
        for (const TypeId id : filter.components()) {
            const ComponentRecord* component = store.find_record(id);
            if (!component || component->log.last_changed() <= filter.since) continue;
            added.watched[added.count++] = {id, component->sparse.get(), nullptr};
        }
        if (added.count == 0) return false;
        const auto changes = how == ChangeWalk::sweep ? std::nullopt : queued(store, filter);
        if (changes && *changes <= length) {
            length = *changes;
            shortest = &filter;
        }
    }
    if (shortest) list_changes(store, *shortest);
    return true;
}

void FilteredWalk::list_changes(EntityStore& store, const ChangeFilter& filter) {
    listed_ = true;
    const auto components = filter.components();
    for (std::size_t i = 0; i < components.size(); ++i) {
        const ComponentRecord* component = store.find_record(components[i]);
        if (!component || component->log.last_changed() <= filter.since) continue;
        const auto changes = component->log.since(filter.since);
        if (components.size() == 1 && !changes.empty() && changes.front().tick == changes.back().tick) {
            // No tick lists an entity twice.
            for (const auto& change : changes) candidates_.push_back(change.entity);
            return;
        }
        for (const auto& [entity, tick] : changes) {
            // An entity may be listed once per tick and per component: it counts where it stands last and first.
            if (store.changed(components[i], entity) != tick) continue;
            const auto counted = [&](TypeId other) { return store.changed(other, entity) > filter.since; };
            if (std::ranges::none_of(components.first(i), counted)) candidates_.push_back(entity);
        }
    }
}

void FilteredWalk::restrict_to(const SparseStore& store) {
    if (listed_ && candidates_.size() <= store.table.size()) return;
    listed_ = true;
    candidates_.clear();
    const Table& table = store.table;
    for (const std::uint32_t chunk : table.chunks()) {
        const auto entities = table.entities(chunk);
        candidates_.insert(candidates_.end(), entities.begin(), entities.end());
    }
}

bool FilteredWalk::enter(const Table& table, std::uint32_t chunk, const ChunkDirectory& chunks) {
    const ColumnTicks* ticks = chunks.ticks(chunk);
    for (std::size_t i = 0; i < count_; ++i) {
        Filter& filter = filters_[i];
        bool news = false;
        for (std::size_t k = 0; k < filter.count; ++k) {
            Watched& watched = filter.watched[k];
            if (watched.sparse) {
                news = true;
                continue;
            }
            const ColumnTicks* column = table.has(watched.id) ? &ticks[table.column(watched.id)] : nullptr;
            watched.ticks = column && column->latest() > filter.since ? column : nullptr;
            news = news || watched.ticks;
        }
        if (!news) return false;
    }
    return true;
}

bool FilteredWalk::passes(const Filter& filter, Entity entity, std::uint32_t row) {
    for (std::size_t k = 0; k < filter.count; ++k) {
        const Watched& watched = filter.watched[k];
        const ColumnTicks* ticks = watched.ticks;
        std::uint32_t at = row;
        if (watched.sparse) {
            const Location found = watched.sparse->find(entity);
            if (!found) continue;
            ticks = watched.sparse->table.ticks(found.chunk());
            at = found.row();
        }
        if (!ticks) continue;
        if ((filter.event == ChangeFilter::Event::changed ? ticks->changed(at) : ticks->added(at)) > filter.since)
            return true;
    }
    return false;
}

bool FilteredWalk::passes(Entity entity, std::uint32_t row) const {
    const auto end = filters_.begin() + static_cast<std::ptrdiff_t>(count_);
    return std::all_of(filters_.begin(), end, [&](const Filter& filter) { return passes(filter, entity, row); });
}

std::uint32_t FilteredWalk::next(const Entity* entities, std::uint32_t row, std::uint32_t rows) const {
    const Filter& first = filters_[0];
    const bool simple = count_ == 1 && first.count == 1 && first.watched[0].ticks && !first.watched[0].sparse;
    if (simple) {
        const ColumnTicks& ticks = *first.watched[0].ticks;
        return first.event == ChangeFilter::Event::changed ? ticks.next_changed(row, rows, first.since)
                                                           : ticks.next_added(row, rows, first.since);
    }
    while (row < rows && !passes(entities[row], row)) ++row;
    return row;
}

std::uint32_t FilteredWalk::end_of_run(const Entity* entities, std::uint32_t row, std::uint32_t rows) const {
    while (row < rows && passes(entities[row], row)) ++row;
    return row;
}

} // namespace hachure::detail
