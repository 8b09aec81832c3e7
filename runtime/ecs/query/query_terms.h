#pragma once

#include <hachure/runtime/ecs/hierarchy.h>
#include <hachure/runtime/ecs/storage/entity_store.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace hachure {

/// Query term: fetches a `T*` (or `const T*`), null where the entity has none. T may be an `OfParent`.
template <class T> struct Optional {};
/// Query term: the entity has all of these; they are not fetched.
template <class... T> struct With {};
/// Query term: the entity has none of these.
template <class... T> struct Without {};
/// Query term: the entity has at least one of these; fetches a pointer for each, null where it has none.
template <class... T> struct AnyOf {};
/// Query term: the entity's parent has a T, which is fetched to read: `OfParent<const T>`.
template <class T> struct OfParent {};

namespace detail {

/// The row on the walk.
struct Visit {
    EntityStore& store;
    Table& table;
    std::uint32_t chunk;
    std::uint32_t row;

    Location at() const { return {chunk, row}; }
    Entity entity() const { return table.entities(chunk)[row]; }
};

/// Picks the shortest of the sparse stores that every match is in.
struct Driver {
    const SparseStore* shortest = nullptr;
    bool impossible = false; ///< nothing can match

    void require(const ComponentRecord* component) {
        if (!component)
            impossible = true;
        else if (!shortest || component->sparse->table.size() < shortest->table.size())
            shortest = component->sparse.get();
    }
};

/// What a component term knows of the row on the walk. Trivial, so that a walk can live in registers.
template <class C, bool sparse = is_sparse<C>> struct ColumnCursor;

/// Of a component in tables: where its column begins in this chunk, or null.
template <class C> struct ColumnCursor<C, false> {
    static constexpr bool by_row = false;
    std::byte* base = nullptr;
    TypeId id = 0; ///< for `locate`

    void begin(EntityStore& store) { id = store.known(component_id<C>()); }
    void enter(const Visit& visit) {
        const auto& chunk = visit.store.chunks()[visit.chunk];
        const std::uint32_t offset = visit.table.offset(component_id<C>());
        base = offset == 0 ? nullptr : chunk.data + offset;
    }
    void locate(const ChunkDirectory::Chunk& chunk) {
        const std::uint32_t offset = chunk.offsets[id];
        base = offset == 0 ? nullptr : chunk.data + offset;
    }
    void prefetch(const EntityStore& store, Location at) const {
        const std::byte* data = store.chunks()[at.chunk()].data + store.offset(at.chunk(), component_id<C>());
        __builtin_prefetch(data + std::size_t{at.row()} * stride_of<C>);
    }
    void select(const Visit&) {}
    bool present() const { return base != nullptr; }
    C* get(std::uint32_t row) const { return reinterpret_cast<C*>(base + std::size_t{row} * stride_of<C>); }
    C* get_or_null(std::uint32_t row) const { return base ? get(row) : nullptr; }
    void mark_row(const Visit& visit, Tick now) const {
        if (base) visit.store.mark(component_id<C>(), visit.entity(), visit.at(), now);
    }
    void mark_chunk(const Visit& visit, Tick now) const {
        if (base) visit.store.mark_chunk(visit.table, visit.chunk, visit.table.column(component_id<C>()), now);
    }
};

/// Of a sparse component: the value of this row's entity, or null.
template <class C> struct ColumnCursor<C, true> {
    static constexpr bool by_row = true;
    const SparseStore* sparse = nullptr;
    C* value = nullptr;
    Location at;

    void begin(EntityStore& store) {
        const ComponentRecord* component = store.find_record(component_id<C>());
        sparse = component ? component->sparse.get() : nullptr;
    }
    void enter(const Visit&) {}
    void select(const Visit& visit) {
        at = sparse ? sparse->find(visit.entity()) : Location{};
        value = at ? reinterpret_cast<C*>(sparse->table.value(at, 0)) : nullptr;
    }
    bool present() const { return value != nullptr; }
    C* get(std::uint32_t) const { return value; }
    C* get_or_null(std::uint32_t) const { return value; }
    void mark_row(const Visit& visit, Tick now) const {
        if (value) visit.store.mark(component_id<C>(), visit.entity(), at, now);
    }
    void mark_chunk(const Visit&, Tick) const {}
    void prefetch(const EntityStore&, Location) const {}
};

template <class T> inline constexpr bool may_be_term = std::is_const_v<T> || !managed_by_world<std::remove_const_t<T>>;

template <class C> bool table_has(const Table& table) {
    return is_sparse<C> || table.has(component_id<std::remove_const_t<C>>());
}

template <class C> bool table_lacks(const Table& table) {
    return is_sparse<C> || !table.has(component_id<std::remove_const_t<C>>());
}

template <class C> void require_sparse(EntityStore& store, Driver& driver) {
    if constexpr (is_sparse<C>) driver.require(store.find_record(component_id<std::remove_const_t<C>>()));
}

/// What a term does on the walk. `matches` says whether rows of a table can match at all; `choose` what sparse stores
/// matches are in; `begin`, `enter` and `match` go to a world, a chunk, and (if `by_row`) a row, where `match` says
/// whether the term takes it; `fetch` gives its part of the result. Where rows need not be looked at, `locate` goes,
/// after `begin`, to a chunk of any table, and says whether its rows match. T is a component, const or not.
template <class T> class Term {
    static_assert(may_be_term<T>, "Parent and Children change through set_parent and clear_parent");
    using C = std::remove_const_t<T>;

public:
    static constexpr bool writes = !std::is_const_v<T>;
    static constexpr bool by_row = is_sparse<C>;

    static bool matches(const Table& table) { return table_has<C>(table); }
    static void choose(EntityStore& store, Driver& driver) { require_sparse<C>(store, driver); }

    void begin(EntityStore& store) { cursor_.begin(store); }
    void enter(const Visit& visit) { cursor_.enter(visit); }
    bool match(const Visit& visit) {
        cursor_.select(visit);
        return cursor_.present();
    }
    std::tuple<T&> fetch(std::uint32_t row) const { return {*cursor_.get(row)}; }
    void mark_row(const Visit& visit, Tick now) const { cursor_.mark_row(visit, now); }
    void mark_chunk(const Visit& visit, Tick now) const { cursor_.mark_chunk(visit, now); }
    bool locate(const ChunkDirectory::Chunk& chunk) {
        cursor_.locate(chunk);
        return cursor_.present();
    }
    void prefetch(const EntityStore& store, Location at) const { cursor_.prefetch(store, at); }

private:
    ColumnCursor<C> cursor_;
};

/// At least `least` of T..., fetched as pointers.
template <std::size_t least, class... T> class PointerTerm {
    static_assert((may_be_term<T> && ...), "Parent and Children change through set_parent and clear_parent");

public:
    static constexpr bool writes = (!std::is_const_v<T> || ...);
    static constexpr bool by_row = (is_sparse<T> || ...);

    static bool matches(const Table& table) { return least == 0 || (table_has<T>(table) || ...); }
    static void choose(EntityStore&, Driver&) {}

    void begin(EntityStore& store) { (cursor<T>().begin(store), ...); }
    void enter(const Visit& visit) { (cursor<T>().enter(visit), ...); }
    bool match(const Visit& visit) {
        (cursor<T>().select(visit), ...);
        return least == 0 || (cursor<T>().present() || ...);
    }
    std::tuple<T*...> fetch(std::uint32_t row) const { return {cursor<T>().get_or_null(row)...}; }
    void mark_row(const Visit& visit, Tick now) const { (mark_row_if<T>(visit, now), ...); }
    void mark_chunk(const Visit& visit, Tick now) const { (mark_chunk_if<T>(visit, now), ...); }
    bool locate(const ChunkDirectory::Chunk& chunk) {
        (cursor<T>().locate(chunk), ...);
        return least == 0 || (cursor<T>().present() || ...);
    }
    void prefetch(const EntityStore& store, Location at) const { (cursor<T>().prefetch(store, at), ...); }

private:
    template <class U> using CursorOf = ColumnCursor<std::remove_const_t<U>>;
    template <class U> CursorOf<U>& cursor() { return std::get<CursorOf<U>>(cursors_); }
    template <class U> const CursorOf<U>& cursor() const { return std::get<CursorOf<U>>(cursors_); }
    template <class U> void mark_row_if(const Visit& visit, Tick now) const {
        if constexpr (!std::is_const_v<U>) cursor<U>().mark_row(visit, now);
    }
    template <class U> void mark_chunk_if(const Visit& visit, Tick now) const {
        if constexpr (!std::is_const_v<U>) cursor<U>().mark_chunk(visit, now);
    }

    std::tuple<CursorOf<T>...> cursors_;
};

template <class T> class Term<Optional<T>> : public PointerTerm<0, T> {};
template <class... T> class Term<AnyOf<T...>> : public PointerTerm<1, T...> {};

/// What terms have in common that fetch nothing.
class SilentTerm {
public:
    static constexpr bool writes = false;
    void enter(const Visit&) {}
    std::tuple<> fetch(std::uint32_t) const { return {}; }
    void mark_row(const Visit&, Tick) const {}
    void mark_chunk(const Visit&, Tick) const {}
    void prefetch(const EntityStore&, Location) const {}
};

/// Sparse stores that rows are looked up in.
template <class... T> class SparseLookups {
public:
    void begin(EntityStore& store) {
        std::size_t i = 0;
        ((is_sparse<T> ? void(stores_[i++] = find<T>(store)) : void()), ...);
    }
    bool in_all(Entity entity) const {
        for (const SparseStore* store : stores_)
            if (!store || !store->find(entity)) return false;
        return true;
    }
    bool in_any(Entity entity) const {
        for (const SparseStore* store : stores_)
            if (store && store->find(entity)) return true;
        return false;
    }

private:
    template <class U> static const SparseStore* find(EntityStore& store) {
        const ComponentRecord* component = store.find_record(component_id<std::remove_const_t<U>>());
        return component ? component->sparse.get() : nullptr;
    }
    std::array<const SparseStore*, (std::size_t{0} + ... + is_sparse<T>)> stores_{};
};

template <class... T> class Term<With<T...>> : public SilentTerm {
public:
    static constexpr bool by_row = (is_sparse<T> || ...);
    static bool matches(const Table& table) { return (table_has<T>(table) && ...); }
    static void choose(EntityStore& store, Driver& driver) { (require_sparse<T>(store, driver), ...); }
    void begin(EntityStore& store) {
        ids_ = {store.known(component_id<std::remove_const_t<T>>())...};
        sparse_.begin(store);
    }
    bool match(const Visit& visit) { return sparse_.in_all(visit.entity()); }
    bool locate(const ChunkDirectory::Chunk& chunk) const {
        return std::ranges::all_of(ids_, [&](TypeId id) { return chunk.offsets[id] != 0; });
    }

private:
    std::array<TypeId, sizeof...(T)> ids_{}; ///< for `locate`
    SparseLookups<T...> sparse_;
};

template <class... T> class Term<Without<T...>> : public SilentTerm {
public:
    static constexpr bool by_row = (is_sparse<T> || ...);
    static bool matches(const Table& table) { return (table_lacks<T>(table) && ...); }
    static void choose(EntityStore&, Driver&) {}
    void begin(EntityStore& store) {
        ids_ = {store.known(component_id<std::remove_const_t<T>>())...};
        sparse_.begin(store);
    }
    bool match(const Visit& visit) { return !sparse_.in_any(visit.entity()); }
    bool locate(const ChunkDirectory::Chunk& chunk) const {
        return std::ranges::all_of(ids_, [&](TypeId id) { return chunk.offsets[id] == 0; });
    }

private:
    std::array<TypeId, sizeof...(T)> ids_{}; ///< for `locate`
    SparseLookups<T...> sparse_;
};

/// Looks a component of the parent up; siblings that follow each other share one look-up.
template <class T> class ParentCursor {
    static_assert(std::is_const_v<T>, "a parent's component is fetched to read: OfParent<const T>");
    using C = std::remove_const_t<T>;

public:
    void enter(const Visit& visit) { parents_.enter(visit); }

    T* find(const Visit& visit) {
        const Parent* parent = parents_.get_or_null(visit.row);
        if (!parent) return nullptr;
        if (parent->entity != parent_) {
            parent_ = parent->entity;
            Location at;
            value_ = visit.store.template find<C>(parent_, at);
        }
        return value_;
    }

private:
    ColumnCursor<Parent> parents_;
    Entity parent_ = Entity::null;
    T* value_ = nullptr;
};

template <class T> class Term<OfParent<T>> : public SilentTerm {
public:
    static constexpr bool by_row = true;
    static bool matches(const Table& table) { return table_has<Parent>(table); }
    static void choose(EntityStore&, Driver&) {}
    void begin(EntityStore&) {}
    void enter(const Visit& visit) { cursor_.enter(visit); }
    bool match(const Visit& visit) { return (value_ = cursor_.find(visit)) != nullptr; }
    std::tuple<T&> fetch(std::uint32_t) const { return {*value_}; }

private:
    ParentCursor<T> cursor_;
    T* value_ = nullptr;
};

template <class T> class Term<Optional<OfParent<T>>> : public SilentTerm {
public:
    static constexpr bool by_row = true;
    static bool matches(const Table&) { return true; }
    static void choose(EntityStore&, Driver&) {}
    void begin(EntityStore&) {}
    void enter(const Visit& visit) { cursor_.enter(visit); }
    bool match(const Visit& visit) {
        value_ = cursor_.find(visit);
        return true;
    }
    std::tuple<T*> fetch(std::uint32_t) const { return {value_}; }

private:
    ParentCursor<T> cursor_;
    T* value_ = nullptr;
};

/// Whether a term fetches C of the entities themselves.
template <class C, class T> inline constexpr bool names = std::is_same_v<C, std::remove_const_t<T>>;
template <class C, class T> inline constexpr bool names<C, Optional<T>> = names<C, T>;
template <class C, class... T> inline constexpr bool names<C, AnyOf<T...>> = (names<C, T> || ...);
template <class C, class... Terms> inline constexpr bool is_named = (names<C, Terms> || ...);

} // namespace detail
} // namespace hachure
