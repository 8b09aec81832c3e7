#pragma once

#include <hachure/runtime/ecs/component_store.h>
#include <hachure/runtime/ecs/hierarchy.h>

#include <array>
#include <tuple>
#include <type_traits>

namespace hachure {

/// Query term: fetches a `T*` (or `const T*`), null where the entity has none.
template <class T> struct Optional {};
/// Query term: the entity has all of these; they are not fetched.
template <class... T> struct With {};
/// Query term: the entity has none of these.
template <class... T> struct Without {};

namespace detail {

/// Picks the shortest of the stores that a match must be in; that one is walked.
struct DriverChoice {
    const StoreBase* shortest = nullptr;
    bool impossible = false; ///< nothing can match

    void require(const StoreBase* store) {
        if (!store) {
            impossible = true;
        } else if (!shortest || store->entities().size() < shortest->entities().size()) {
            shortest = store;
        }
    }
};

/// One entity on the walk: row `row` of the driver, or of the list of all entities when the driver is null.
struct Visit {
    Entity entity;
    const StoreBase* driver;
    std::uint32_t row;

    std::uint32_t row_in(const StoreBase& store) const { return &store == driver ? row : store.row_of_live(entity); }
};

/// What a term does on the walk: `choose` says what it requires, `match` whether it takes an entity (and notes its
/// row), `fetch` gives its part of the result for the entity that matched last. T is a component, const or not.
template <class T> class Term {
    using Component = std::remove_const_t<T>;
    using Store = std::conditional_t<std::is_const_v<T>, const ComponentStore<Component>, ComponentStore<Component>>;
    static_assert(std::is_const_v<T> || !managed_by_world<Component>,
                  "Parent and Children change through set_parent and clear_parent");

public:
    static constexpr bool writes = !std::is_const_v<T>;

    template <class Stores> explicit Term(Stores& stores) : store_(stores.template find<Component>()) {}

    void choose(DriverChoice& choice) const { choice.require(store_); }

    bool match(const Visit& visit) {
        row_ = visit.row_in(*store_);
        return row_ != no_row;
    }

    std::tuple<T&> fetch([[maybe_unused]] Tick now) const {
        if constexpr (writes) store_->mark_changed(row_, now);
        return {store_->value(row_)};
    }

private:
    Store* store_;
    std::uint32_t row_ = no_row;
};

template <class T> class Term<Optional<T>> {
    using Component = std::remove_const_t<T>;
    using Store = std::conditional_t<std::is_const_v<T>, const ComponentStore<Component>, ComponentStore<Component>>;
    static_assert(std::is_const_v<T> || !managed_by_world<Component>,
                  "Parent and Children change through set_parent and clear_parent");

public:
    static constexpr bool writes = !std::is_const_v<T>;

    template <class Stores> explicit Term(Stores& stores) : store_(stores.template find<Component>()) {}

    void choose(DriverChoice&) const {}

    bool match(const Visit& visit) {
        row_ = store_ ? visit.row_in(*store_) : no_row;
        return true;
    }

    std::tuple<T*> fetch([[maybe_unused]] Tick now) const {
        if (row_ == no_row) return {nullptr};
        if constexpr (writes) store_->mark_changed(row_, now);
        return {&store_->value(row_)};
    }

private:
    Store* store_;
    std::uint32_t row_ = no_row;
};

template <class... T> class Term<With<T...>> {
public:
    static constexpr bool writes = false;

    template <class Stores>
    explicit Term(Stores& stores) : stores_{stores.template find<std::remove_const_t<T>>()...} {}

    void choose(DriverChoice& choice) const {
        for (const StoreBase* store : stores_) choice.require(store);
    }

    bool match(const Visit& visit) const {
        for (const StoreBase* store : stores_)
            if (visit.row_in(*store) == no_row) return false;
        return true;
    }

    std::tuple<> fetch(Tick) const { return {}; }

private:
    std::array<const StoreBase*, sizeof...(T)> stores_;
};

template <class... T> class Term<Without<T...>> {
public:
    static constexpr bool writes = false;

    template <class Stores>
    explicit Term(Stores& stores) : stores_{stores.template find<std::remove_const_t<T>>()...} {}

    void choose(DriverChoice&) const {}

    bool match(const Visit& visit) const {
        for (const StoreBase* store : stores_)
            if (store && visit.row_in(*store) != no_row) return false;
        return true;
    }

    std::tuple<> fetch(Tick) const { return {}; }

private:
    std::array<const StoreBase*, sizeof...(T)> stores_;
};

} // namespace detail
} // namespace hachure
