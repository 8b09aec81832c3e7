#pragma once

#include <hachure/runtime/ecs/entity_table.h>
#include <hachure/runtime/ecs/iteration_lock.h>
#include <hachure/runtime/ecs/query_filter.h>
#include <hachure/runtime/ecs/query_terms.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace hachure {

namespace detail {
/// The parts of a world that a query works on.
struct QuerySource {
    StoreTable* stores;
    const EntityTable* entities;
    IterationLock* lock;
    const Tick* now;
};
} // namespace detail

/// The entities that satisfy every term, made by `World::query`. Terms are `T` (fetched to write; marked changed when
/// visited), `const T` (fetched to read), `Optional<T>`, `Optional<const T>`, `With<T...>` and `Without<T...>`.
///
///     for (auto [entity, transform, mesh] : world.query<const Transform, Mesh, Without<Hidden>>()) ...
///
/// A visit gives `std::tuple<Entity, ...>` with a reference or pointer for each fetched term, in order; references hold
/// until the next structural change. The order of visits is unspecified, but the same after the same calls.
///
/// While a query is walked, creating and destroying entities and adding and removing components asserts: queue such
/// changes in `Commands`. Writing components, and replacing one by `World::add`, are allowed. A query is a light value;
/// it may be kept and walked again, as long as the world neither dies nor moves. Walking allocates nothing.
template <class... Terms> class Query {
public:
    /// What a visit gives.
    using Item = decltype(std::tuple_cat(std::declval<std::tuple<Entity>>(),
                                         std::declval<detail::Term<Terms>>().fetch(Tick{})...));

    class Iterator;

    /// Whether a walk writes any component.
    static constexpr bool writes = (detail::Term<Terms>::writes || ...);

    explicit Query(detail::QuerySource source) : source_(source) {}

    Iterator begin() const { return Iterator(source_, filters_); }
    std::default_sentinel_t end() const { return {}; }

    /// Calls `f(entity, fetched...)`, or `f(fetched...)` where f does not take the entity.
    template <class F> void each(F&& f) const {
        for (Iterator it = begin(); it != end(); ++it) {
            std::apply(
                [&f](Entity entity, auto&&... fetched) {
                    if constexpr (std::is_invocable_v<F&, Entity, decltype(fetched)...>) {
                        std::invoke(f, entity, std::forward<decltype(fetched)>(fetched)...);
                    } else {
                        std::invoke(f, std::forward<decltype(fetched)>(fetched)...);
                    }
                },
                *it);
        }
    }

    /// The first entity of the walk, or null. Marks nothing changed, as `empty` and `count` do not.
    Entity first() const {
        const Iterator it = begin();
        return it != end() ? it.entity() : Entity::null;
    }

    bool empty() const { return !first(); }

    /// How many entities match; walks them.
    std::size_t count() const {
        std::size_t matches = 0;
        for (Iterator it = begin(); it != end(); ++it) ++matches;
        return matches;
    }

    /// The same query, only for entities that have at least one of C... changed (or added) after tick `since`. Chained
    /// filters must all hold. Costs next to nothing when no entity at all had a change of C... since.
    template <class... C> Query changed_since(Tick since) const {
        return filtered<C...>(detail::ChangeFilter::Event::changed, since);
    }

    /// The same, for C... added after tick `since`.
    template <class... C> Query added_since(Tick since) const {
        return filtered<C...>(detail::ChangeFilter::Event::added, since);
    }

private:
    template <class... C> Query filtered(detail::ChangeFilter::Event event, Tick since) const {
        Query result = *this;
        result.filters_.append().set(event, since, std::array{detail::component_id<std::remove_const_t<C>>()...});
        return result;
    }

    detail::QuerySource source_;
    detail::ChangeFilters filters_;
};

/// A walk over a query: an input iterator that keeps the world's structure locked while it lives. Dereferencing is the
/// visit that marks written components changed.
template <class... Terms> class Query<Terms...>::Iterator {
public:
    using value_type = Item;
    using difference_type = std::ptrdiff_t;

    Iterator(const detail::QuerySource& source, const detail::ChangeFilters& filters)
        : terms_(detail::Term<Terms>(*source.stores)...), filters_(filters), now_(*source.now), guard_(*source.lock) {
        detail::DriverChoice choice;
        std::apply([&choice](const auto&... term) { (term.choose(choice), ...); }, terms_);
        filters_.choose(*source.stores, choice);
        visit_.driver = choice.shortest;
        if (!choice.impossible) entities_ = choice.shortest ? choice.shortest->entities() : source.entities->entities();
        find_match();
    }

    Item operator*() const {
        return std::apply(
            [this](const auto&... term) {
                return std::tuple_cat(std::tuple<Entity>(visit_.entity), term.fetch(now_)...);
            },
            terms_);
    }

    Iterator& operator++() {
        ++visit_.row;
        find_match();
        return *this;
    }
    void operator++(int) { ++*this; }

    /// The entity of this visit.
    Entity entity() const { return visit_.entity; }

    friend bool operator==(const Iterator& it, std::default_sentinel_t) { return it.visit_.row == it.entities_.size(); }

private:
    void find_match() {
        for (; visit_.row < entities_.size(); ++visit_.row) {
            visit_.entity = entities_[visit_.row];
            const bool all = std::apply([this](auto&... term) { return (term.match(visit_) && ...); }, terms_);
            if (all && filters_.match(visit_)) return;
        }
    }

    std::tuple<detail::Term<Terms>...> terms_;
    detail::ChangeFilters filters_;
    std::span<const Entity> entities_;
    detail::Visit visit_{Entity::null, nullptr, 0};
    Tick now_;
    detail::IterationLock::Guard guard_;
};

} // namespace hachure
