#pragma once

#include <hachure/runtime/ecs/query/query_cursor.h>
#include <hachure/runtime/parallel.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace hachure {

/// The entities that satisfy every term, made by `World::query`. Terms are `T` (fetched to write; marked changed when
/// visited), `const T` (fetched to read), `Optional<T>`, `With<T...>`, `Without<T...>`, `AnyOf<T...>` and
/// `OfParent<const T>`.
///
///     for (auto [entity, transform, mesh] : world.query<const Transform, Mesh, Without<Hidden>>()) ...
///
/// A visit gives `std::tuple<Entity, ...>` with a reference or pointer for each fetched term, in order; references hold
/// until the next structural change. The order of visits is unspecified, but the same after the same calls.
///
/// Which tables of a world match is remembered by the world: a query that matches nothing costs next to nothing.
/// `each` is the fastest walk: where no term and no filter looks at single rows, it is a loop over plain arrays.
///
/// While a query is walked, creating and destroying entities and adding and removing components asserts: queue such
/// changes in `Commands`. Writing components, and replacing one by `World::add`, are allowed. A query is a light value;
/// it may be kept and walked again, as long as the world lives; it outlives its iterators. Walking allocates nothing
/// in the long run.
template <class... Terms> class Query {
    using Cursor = detail::Cursor<Terms...>;

public:
    /// What a visit gives.
    using Item = decltype(std::declval<const Cursor&>().fetch());

    class Iterator;

    /// Whether a walk writes any component.
    static constexpr bool writes = Cursor::writes;

    /// The query of a world. Writing marks in tick `now`, in the world's own tick when 0.
    explicit Query(detail::EntityStore& store, Tick now = 0) : store_(&store), now_(now) {}

    Iterator begin() const { return Iterator(*this, true); }
    std::default_sentinel_t end() const { return {}; }

    /// Calls `f(entity, fetched...)`, or `f(fetched...)` where f does not take the entity. When f throws, entities that
    /// it was not called for may be marked changed as well.
    template <class F> void each(F&& f) const;

    /// As `each`, for those of `entities` that match, in their order; one that is listed twice is visited twice. What
    /// the next ones need is fetched from memory while f runs.
    template <class F> void each_of(std::span<const Entity> entities, F&& f) const;

    /// Calls `f(entities, fetched...)` for packed runs of entities: a span of handles, and for each fetched term a span
    /// of as many values; where an optional component is absent, an empty one. All of a run is marked changed. Only for
    /// terms in tables, and without change filters.
    template <class F> void each_chunk(F&& f) const;

    /// As `each`, on several threads at once (see `set_thread_limit`). f is called for each match once, in no order,
    /// by several threads at a time: it writes nothing but the components that it was given.
    template <class F> void parallel_each(F&& f) const;

    /// As `each_chunk`, on several threads at once.
    template <class F> void parallel_each_chunk(F&& f) const;

    /// Every match, in ascending order of `key(fetched...)` or `key(entity, fetched...)`; equal keys in the order of
    /// the walk. All are visited by this; references hold until the next structural change.
    template <class Key> std::vector<Item> sorted(Key&& key) const;

    /// Whether the entity is alive and matches.
    bool contains(Entity entity) const { return find_row(entity).has_value(); }

    /// Visits one entity; nothing where it does not match.
    std::optional<Item> find(Entity entity) const {
        auto cursor = find_row(entity);
        if (!cursor) return std::nullopt;
        if constexpr (writes) cursor->mark_selected();
        return cursor->fetch(entity);
    }

    /// The first entity of the walk, or null. Marks nothing changed, as `empty`, `count` and `contains` do not.
    Entity first() const {
        const Iterator it(*this, false);
        return it != end() ? it.entity() : Entity::null;
    }

    bool empty() const { return !first(); }

    /// How many entities match. Where rows need not be looked at, this walks tables, not entities.
    std::size_t count() const;

    /// The same query, only for entities that have at least one of C... changed (or added) after tick `since`. Chained
    /// filters must all hold. Costs next to nothing when no entity at all had a change of C... since, and little while
    /// changed entities are few. The query of a system fetches C..., so that the schedule knows what it reads.
    template <class... C> Query changed_since(Tick since) const {
        return filtered<C...>(detail::ChangeFilter::Event::changed, since);
    }

    /// The same, for C... added after tick `since`.
    template <class... C> Query added_since(Tick since) const {
        return filtered<C...>(detail::ChangeFilter::Event::added, since);
    }

    /// The same query, finding changed entities in the way that is said; `automatic` is what all others do.
    Query finding_changes(detail::ChangeWalk how) const {
        Query result = *this;
        result.how_ = how;
        return result;
    }

    /// For the world itself: the tables whose rows all match, where no term or filter looks at rows.
    const std::vector<detail::Table*>* whole_tables() const;

private:
    struct Block {
        detail::Table* table;
        std::uint32_t chunk;
        std::uint32_t rows;
    };

    static std::uint32_t rows_of(const detail::Table& table, std::uint32_t chunk) {
        return static_cast<std::uint32_t>(table.entities(chunk).size());
    }

    template <class... C> Query filtered(detail::ChangeFilter::Event event, Tick since) const {
        HACHURE_ASSERT(now_ == 0 || (detail::is_named<std::remove_const_t<C>, Terms...> && ...),
                       "the query of a system fetches the components whose changes it asks for");
        Query result = *this;
        result.filters_.add(event, since, std::array{detail::component_id<std::remove_const_t<C>>()...});
        return result;
    }

    Tick now() const { return now_ ? now_ : store_->tick(); }
    bool plain() const { return !Cursor::by_row && filters_.empty(); }
    Cursor cursor_at(const detail::QueryCache& cache) const;
    std::vector<Block> blocks(const detail::QueryCache& cache) const;
    const detail::QueryCache& cache() const;
    /// `each_of` for up to `block_size` entities.
    template <class F> void visit_rows_of(Cursor cursor, std::span<const Entity> entities, F& f) const;
    static constexpr std::size_t block_size = 32;
    std::optional<Cursor> find_row(Entity entity) const;
    bool passes_filters(Entity entity) const;
    template <class F> static void visit_rows(Cursor& cursor, std::uint32_t rows, F& f);
    template <class F> static void visit_chunk(Cursor& cursor, std::uint32_t rows, F& f);
    template <class Visit> void in_parallel(Visit&& visit) const;
    std::vector<Item> all_items() const;

    /// Enough for one task to outweigh handing it to another thread.
    static constexpr std::uint32_t rows_per_task = 4096;

    detail::EntityStore* store_;
    Tick now_;
    detail::ChangeWalk how_ = detail::ChangeWalk::automatic;
    detail::ChangeFilters filters_;
};

/// A walk over a query: an input iterator that keeps the world's structure locked while it lives. Reaching an entity is
/// the visit; components that are written are marked changed by the end of the walk.
template <class... Terms> class Query<Terms...>::Iterator {
public:
    using value_type = Item;
    using difference_type = std::ptrdiff_t;

    Iterator(const Query& query, bool marks)
        : guard_(query.store_->lock()),
          cursor_(Cursor::begin(*query.store_, query.filters_, query.now(), marks, query.how_)) {}
    Iterator(Iterator&& other) noexcept
        : guard_(std::move(other.guard_)), cursor_(std::exchange(other.cursor_, Cursor{})) {}
    Iterator& operator=(Iterator&& other) noexcept {
        std::swap(guard_, other.guard_);
        std::swap(cursor_, other.cursor_);
        return *this;
    }
    ~Iterator() {
        if (cursor_.walk || !cursor_.at_end()) Cursor::finish(cursor_);
    }

    Item operator*() const { return cursor_.fetch(); }

    Iterator& operator++() {
        if (++cursor_.row == cursor_.stop) cursor_ = Cursor::advance(cursor_);
        return *this;
    }
    void operator++(int) { ++*this; }

    /// The entity of this visit.
    Entity entity() const { return cursor_.entities[cursor_.row]; }

    friend bool operator==(const Iterator& it, std::default_sentinel_t) { return it.cursor_.at_end(); }

private:
    detail::IterationLock::Guard guard_;
    Cursor cursor_;
};

} // namespace hachure

#include <hachure/runtime/ecs/query/query_inline.h>
