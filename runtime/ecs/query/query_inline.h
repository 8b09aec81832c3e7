#pragma once

// The templates of query.h, which includes this.

#include <hachure/runtime/ecs/query.h>

#include <algorithm>
#include <array>

namespace hachure {
namespace detail {

/// Calls f with an item's parts, with or without the entity, as f takes them.
template <class F, class Item> decltype(auto) call_with(F& f, Item&& item) {
    return std::apply(
        [&f](Entity entity, auto&&... fetched) -> decltype(auto) {
            if constexpr (std::is_invocable_v<F&, Entity, decltype(fetched)...>) {
                return std::invoke(f, entity, std::forward<decltype(fetched)>(fetched)...);
            } else {
                return std::invoke(f, std::forward<decltype(fetched)>(fetched)...);
            }
        },
        std::forward<Item>(item));
}

/// Fetches what a term gave from memory.
template <class T> void prefetch(const T& part) { __builtin_prefetch(&part); }
template <class T> void prefetch(T* part) { __builtin_prefetch(part); }

/// The span of `rows` values that begins with what a term fetched of the first row.
template <class T> std::span<T> chunk_span(T* first, std::uint32_t rows) {
    static_assert(!std::is_empty_v<T>, "empty components have no array: ask for them with With<T>");
    return {first, first ? rows : 0};
}
template <class T> std::span<T> chunk_span(T& first, std::uint32_t rows) { return chunk_span(&first, rows); }

} // namespace detail

template <class... Terms> const detail::QueryCache& Query<Terms...>::cache() const {
    return store_->query_cache(detail::type_id<detail::TypeFamily::query, detail::TypeList<Terms...>>(),
                               &Cursor::matches);
}

template <class... Terms> auto Query<Terms...>::cursor_at(const detail::QueryCache& cache) const -> Cursor {
    Cursor cursor;
    cursor.store = store_;
    cursor.cache = &cache;
    cursor.now = now();
    return cursor;
}

template <class... Terms>
template <class F>
void Query<Terms...>::visit_rows(Cursor& cursor, std::uint32_t rows, F& f) {
    // A copy whose address nobody has: its columns stay in registers.
    Cursor local = cursor;
    for (local.row = 0; local.row < rows; ++local.row) detail::call_with(f, local.fetch());
}

template <class... Terms>
template <class F>
void Query<Terms...>::visit_chunk(Cursor& cursor, std::uint32_t rows, F& f) {
    std::apply(
        [&](Entity, auto&&... first) { f(std::span(cursor.entities, rows), detail::chunk_span(first, rows)...); },
        cursor.fetch());
}

template <class... Terms> template <class F> void Query<Terms...>::each(F&& f) const {
    if (!plain()) {
        for (Iterator it = begin(); it != end(); ++it) detail::call_with(f, *it);
        return;
    }
    if constexpr (!Cursor::by_row) {
        const detail::IterationLock::Guard guard(store_->lock());
        const detail::QueryCache& tables = cache();
        Cursor cursor = cursor_at(tables);
        for (detail::Table* table : tables.tables()) {
            for (const std::uint32_t chunk : table->chunks()) {
                cursor.enter(*table, chunk);
                if constexpr (writes) cursor.mark_chunk();
                visit_rows(cursor, rows_of(*table, chunk), f);
            }
        }
    }
}

template <class... Terms>
template <class F>
void Query<Terms...>::visit_rows_of(Cursor cursor, std::span<const Entity> entities, F& f) const {
    // One step after the other for all entities: the loop of a step is short, so many of its fetches from memory are on
    // the way at once, which is what most of the time goes into.
    std::array<detail::Location, block_size> rows;
    std::array<std::optional<Item>, block_size> items;
    store_->ids().find(entities, rows.data());
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (!cursor.select(rows[i])) continue;
        items[i].emplace(cursor.fetch(entities[i]));
        std::apply([](Entity, auto&&... part) { (detail::prefetch(part), ...); }, *items[i]);
    }
    const bool filtered = !filters_.empty();
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (!items[i] || (filtered && !passes_filters(entities[i]))) continue;
        if constexpr (writes) {
            cursor.select(rows[i]);
            cursor.mark_selected();
        }
        detail::call_with(f, *items[i]);
    }
}

template <class... Terms>
template <class F>
void Query<Terms...>::each_of(std::span<const Entity> entities, F&& f) const {
    const detail::IterationLock::Guard guard(store_->lock());
    Cursor cursor = cursor_at(cache());
    cursor.begin_terms();
    if constexpr (Cursor::by_row) {
        for (const Entity entity : entities) {
            if (!cursor.select(store_->ids().find(entity)) || !passes_filters(entity)) continue;
            if constexpr (writes) cursor.mark_selected();
            detail::call_with(f, cursor.fetch(entity));
        }
    } else {
        for (; entities.size() > block_size; entities = entities.subspan(block_size))
            visit_rows_of(cursor, entities.first(block_size), f);
        visit_rows_of(cursor, entities, f);
    }
}

template <class... Terms> template <class F> void Query<Terms...>::each_chunk(F&& f) const {
    static_assert(!Cursor::by_row, "each_chunk is for components in tables: OfParent and sparse ones go row by row");
    HACHURE_ASSERT(filters_.empty(), "each_chunk takes no change filters");
    const detail::IterationLock::Guard guard(store_->lock());
    const detail::QueryCache& tables = cache();
    Cursor cursor = cursor_at(tables);
    for (const Block& block : blocks(tables)) {
        cursor.enter(*block.table, block.chunk);
        if constexpr (writes) cursor.mark_chunk();
        visit_chunk(cursor, block.rows, f);
    }
}

template <class... Terms> auto Query<Terms...>::blocks(const detail::QueryCache& cache) const -> std::vector<Block> {
    std::vector<Block> result;
    for (detail::Table* table : cache.tables())
        for (const std::uint32_t chunk : table->chunks())
            if (const std::uint32_t rows = rows_of(*table, chunk)) result.push_back({table, chunk, rows});
    return result;
}

template <class... Terms> template <class Visit> void Query<Terms...>::in_parallel(Visit&& visit) const {
    const detail::QueryCache& tables = cache();
    const std::vector<Block> all = blocks(tables);
    std::vector<std::size_t> tasks{0};
    std::uint32_t rows = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if constexpr (writes) {
            // Here and not in the tasks: the queues of changes are for one thread.
            Cursor cursor = cursor_at(tables);
            cursor.enter(*all[i].table, all[i].chunk);
            cursor.mark_chunk();
        }
        rows += all[i].rows;
        if (rows < rows_per_task && i + 1 < all.size()) continue;
        tasks.push_back(i + 1);
        rows = 0;
    }
    parallel_for(tasks.size() - 1, [&](std::size_t task) {
        Cursor cursor = cursor_at(tables);
        for (std::size_t i = tasks[task]; i < tasks[task + 1]; ++i) {
            cursor.enter(*all[i].table, all[i].chunk);
            visit(cursor, all[i].rows);
        }
    });
}

template <class... Terms> template <class F> void Query<Terms...>::parallel_each(F&& f) const {
    const detail::IterationLock::Guard guard(store_->lock());
    if (plain()) {
        if constexpr (!Cursor::by_row)
            in_parallel([&f](Cursor& cursor, std::uint32_t rows) { visit_rows(cursor, rows, f); });
        return;
    }
    // Which rows match is found by one thread; the work is shared.
    const std::vector<Item> items = all_items();
    parallel_for((items.size() + rows_per_task - 1) / rows_per_task, [&](std::size_t task) {
        const std::size_t end = std::min(items.size(), (task + 1) * rows_per_task);
        for (std::size_t i = task * rows_per_task; i < end; ++i) detail::call_with(f, Item(items[i]));
    });
}

template <class... Terms> template <class F> void Query<Terms...>::parallel_each_chunk(F&& f) const {
    static_assert(!Cursor::by_row, "each_chunk is for components in tables: OfParent and sparse ones go row by row");
    HACHURE_ASSERT(filters_.empty(), "each_chunk takes no change filters");
    const detail::IterationLock::Guard guard(store_->lock());
    in_parallel([&f](Cursor& cursor, std::uint32_t rows) { visit_chunk(cursor, rows, f); });
}

template <class... Terms> auto Query<Terms...>::all_items() const -> std::vector<Item> {
    std::vector<Item> result;
    for (Iterator it = begin(); it != end(); ++it) result.push_back(*it);
    return result;
}

template <class... Terms> template <class Key> auto Query<Terms...>::sorted(Key&& key) const -> std::vector<Item> {
    const std::vector<Item> items = all_items();
    using Value = std::decay_t<decltype(detail::call_with(key, items.front()))>;
    // Items hold references, which cannot be swapped: places are sorted, not items.
    std::vector<std::pair<Value, std::size_t>> places;
    places.reserve(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) places.emplace_back(detail::call_with(key, Item(items[i])), i);
    std::ranges::stable_sort(places, {}, &std::pair<Value, std::size_t>::first);
    std::vector<Item> result;
    result.reserve(items.size());
    for (const auto& [value, i] : places) result.push_back(items[i]);
    return result;
}

template <class... Terms> auto Query<Terms...>::find_row(Entity entity) const -> std::optional<Cursor> {
    Cursor cursor = cursor_at(cache());
    cursor.begin_terms();
    if (!cursor.select(store_->ids().find(entity))) return std::nullopt;
    if (!passes_filters(entity)) return std::nullopt;
    return cursor;
}

template <class... Terms> bool Query<Terms...>::passes_filters(Entity entity) const {
    return std::ranges::all_of(filters_.all(), [&](const auto& filter) { return filter.passes(*store_, entity); });
}

template <class... Terms> const std::vector<detail::Table*>* Query<Terms...>::whole_tables() const {
    return plain() ? &cache().tables() : nullptr;
}

template <class... Terms> std::size_t Query<Terms...>::count() const {
    std::size_t matches = 0;
    if (plain()) {
        for (const detail::Table* table : cache().tables()) matches += table->size();
        return matches;
    }
    for (Iterator it(*this, false); it != end(); ++it) ++matches;
    return matches;
}

} // namespace hachure
