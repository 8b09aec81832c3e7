#pragma once

#include <hachure/runtime/ecs/query/query_filter.h>
#include <hachure/runtime/ecs/query/query_terms.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace hachure::detail {

/// Where a walk over a query with these terms is. A plain value, handed from call to call: only so can a compiler keep
/// the row and the columns in registers while the loop over the rows of a chunk runs.
///
/// A walk is plain when each row of each matching table matches; then whole columns are marked as it leaves a chunk.
/// Otherwise rows are looked at and marked one by one.
template <class... Terms> struct Cursor {
    static constexpr bool by_row = (Term<Terms>::by_row || ...);
    static constexpr bool writes = (Term<Terms>::writes || ...);

    EntityStore* store = nullptr;
    const QueryCache* cache = nullptr;
    FilteredWalk* walk = nullptr; ///< null on a plain walk
    Tick now = 0;
    bool marks = true;                ///< whether visiting marks what is written
    const Entity* entities = nullptr; ///< of the chunk; null at the end
    std::uint32_t row = 0;
    std::uint32_t first = 0; ///< of the run of matching rows that ends before `stop`
    std::uint32_t stop = 0;  ///< the next row that needs more than a step: behind the chunk, or just the next
    std::uint32_t rows = 0;
    std::uint32_t chunk = 0;
    Table* table = nullptr;
    std::size_t next_table = 0;
    std::size_t next_chunk = 0; ///< of the table; of the candidates when there is a list
    std::tuple<Term<Terms>...> terms;

    bool at_end() const { return entities == nullptr; }
    Visit visit() const { return {*store, *table, chunk, row}; }
    /// After `select`.
    void mark_selected() {
        table = &store->chunks().table(chunk);
        mark_row();
    }

    auto fetch() const { return fetch(entities[row]); }

    /// The same for a row whose entity is known.
    auto fetch(Entity entity) const {
        return std::apply(
            [&](const auto&... term) { return std::tuple_cat(std::tuple<Entity>(entity), term.fetch(row)...); }, terms);
    }

    static bool matches(const Table& table) { return (Term<Terms>::matches(table) && ...); }

    /// At the first match, or at the end. The filters are read here and not kept.
    static Cursor begin(EntityStore& store, const ChangeFilters& filters, Tick now, bool marks, ChangeWalk how);

    /// At the next match, or at the end; for when `++row` has met `stop`.
    static Cursor advance(Cursor cursor);

    /// Ends a walk, wherever it is.
    static void finish(Cursor cursor);

    /// Goes to a chunk of a table that matches: to its first row.
    void enter(Table& in, std::uint32_t id) {
        table = &in;
        chunk = id;
        row = first = 0;
        entities = in.entities(id).data();
        std::apply([this](auto&... term) { (term.enter(visit()), ...); }, terms);
    }

    /// Fetches what a visit of the entity at `at` will read from memory.
    void prefetch(Location at) const {
        if (at) std::apply([&](const auto&... term) { (term.prefetch(*store, at), ...); }, terms);
    }

    void mark_chunk() const {
        std::apply([this](const auto&... term) { (mark_column(term), ...); }, terms);
    }
    /// Marks the rows of the run below `end`. Of terms that look at rows, `row` is the only one.
    void mark_run(std::uint32_t end) {
        const std::uint32_t left = row;
        for (row = first; row < end; ++row) mark_row();
        row = left;
    }
    void mark_row() const {
        std::apply([this](const auto&... term) { (mark_one(term), ...); }, terms);
    }

    void begin_terms() {
        std::apply([this](auto&... term) { (term.begin(*store), ...); }, terms);
    }

    /// After `begin_terms`: takes the entity at `at` where there is one that matches all terms; it is the row then.
    bool select(Location at) {
        if constexpr (by_row) {
            return locate(at) && match_row();
        } else {
            if (!at) return false;
            const ChunkDirectory::Chunk& place = store->chunks()[at.chunk()];
            chunk = at.chunk();
            row = at.row();
            return std::apply([&](auto&... term) { return (term.locate(place) && ...); }, terms);
        }
    }

private:
    template <class T> void mark_column(const T& term) const {
        if constexpr (T::writes) term.mark_chunk(visit(), now);
    }
    template <class T> void mark_one(const T& term) const {
        if constexpr (T::writes) term.mark_row(visit(), now);
    }
    /// Goes from `row` on to a row that passes the filters; false when the chunk has no more.
    bool find_news() {
        if (row < rows && walk->filtered()) row = walk->next(entities, row, rows);
        return row < rows;
    }
    bool match_row() {
        return std::apply([this](auto&... term) { return (match_term(term) && ...); }, terms);
    }
    template <class T> bool match_term(T& term) const {
        if constexpr (T::by_row)
            return term.match(visit());
        else
            return true;
    }
    bool next_block();
    bool next_candidate();
    bool locate(Location at);
    void end() {
        entities = nullptr;
        row = stop = rows = 0;
    }
};

template <class... Terms>
Cursor<Terms...> Cursor<Terms...>::begin(EntityStore& store, const ChangeFilters& filters, Tick now, bool marks,
                                         ChangeWalk how) {
    Cursor cursor;
    cursor.store = &store;
    cursor.now = now;
    cursor.marks = writes && marks;
    cursor.cache = &store.query_cache(type_id<TypeFamily::query, TypeList<Terms...>>(), &Cursor::matches);
    if (cursor.cache->tables().empty()) return cursor;

    if constexpr (by_row) cursor.begin_terms();
    if (by_row || !filters.empty()) {
        std::size_t rows = 0;
        for (const Table* table : cursor.cache->tables()) rows += table->size();
        Driver driver;
        (Term<Terms>::choose(store, driver), ...);
        if (driver.impossible) return cursor;
        cursor.walk = store.begin_walk();
        if (!cursor.walk->begin(store, filters, rows, how)) {
            finish(cursor);
            cursor.walk = nullptr;
            return cursor;
        }
        // Going to an entity of a list costs as much as looking a few rows' entities up in the sparse store.
        constexpr std::size_t step_of_list = 4;
        if (driver.shortest && driver.shortest->table.size() < rows / step_of_list)
            cursor.walk->restrict_to(*driver.shortest);
    }
    return advance(cursor);
}

template <class... Terms> Cursor<Terms...> Cursor<Terms...>::advance(Cursor cursor) {
    if (!cursor.walk) {
        if (!cursor.at_end() && cursor.marks) cursor.mark_chunk();
        if (cursor.next_block())
            cursor.stop = cursor.rows;
        else
            cursor.end();
        return cursor;
    }
    if (!cursor.at_end() && cursor.marks) cursor.mark_run(cursor.stop);
    for (;;) {
        for (; cursor.find_news(); ++cursor.row) {
            if (!cursor.match_row()) continue;
            cursor.first = cursor.row;
            cursor.stop = cursor.row + 1;
            if constexpr (!by_row) cursor.stop = cursor.walk->end_of_run(cursor.entities, cursor.stop, cursor.rows);
            return cursor;
        }
        if (cursor.walk->listed() ? !cursor.next_candidate() : !cursor.next_block()) {
            cursor.end();
            return cursor;
        }
    }
}

template <class... Terms> void Cursor<Terms...>::finish(Cursor cursor) {
    // Left in the middle: only what was reached counts as visited. On a plain walk a run begins with the chunk.
    if (!cursor.at_end() && cursor.marks) cursor.mark_run(cursor.row + 1);
    if (cursor.walk) cursor.store->end_walk(cursor.walk);
}

template <class... Terms> bool Cursor<Terms...>::next_block() {
    const auto& tables = cache->tables();
    for (;;) {
        while (!table || next_chunk == table->chunks().size()) {
            if (next_table == tables.size()) return false;
            table = tables[next_table++];
            next_chunk = 0;
        }
        const std::uint32_t id = table->chunks()[next_chunk];
        ++next_chunk;
        rows = static_cast<std::uint32_t>(table->entities(id).size());
        if (rows == 0 || (walk && walk->filtered() && !walk->enter(*table, id, store->chunks()))) continue;
        enter(*table, id);
        return true;
    }
}

template <class... Terms> bool Cursor<Terms...>::next_candidate() {
    constexpr std::size_t ahead = 16;
    const auto candidates = walk->candidates();
    while (next_chunk < candidates.size()) {
        if (next_chunk + 2 * ahead < candidates.size()) store->ids().prefetch(candidates[next_chunk + 2 * ahead]);
        if (next_chunk + ahead < candidates.size()) prefetch(store->ids().find(candidates[next_chunk + ahead]));
        if (locate(store->ids().find(candidates[next_chunk++]))) return true;
    }
    return false;
}

template <class... Terms> bool Cursor<Terms...>::locate(Location at) {
    if (!at) return false;
    Table& in = store->table_of(at);
    if (!cache->contains(in)) return false;
    if (walk && walk->filtered() && !walk->enter(in, at.chunk(), store->chunks())) return false;
    enter(in, at.chunk());
    row = at.row();
    rows = row + 1;
    return true;
}

} // namespace hachure::detail
