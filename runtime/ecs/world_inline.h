#pragma once

// The templates of world.h, which includes this.

#include <hachure/runtime/ecs/world.h>

#include <utility>

namespace hachure {

template <Component... C> Entity World::create_with(C... components) {
    const Entity entity = create();
    (add<C>(entity, std::move(components)), ...);
    return entity;
}

template <Component... C> std::vector<Entity> World::create_many(std::size_t count, const C&... components) {
    std::vector<Entity> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i) result.push_back(create_with<C...>(components...));
    return result;
}

template <Component... C, class F> void World::create_each(std::size_t count, F&& init) {
    for (std::size_t i = 0; i < count; ++i) {
        const Entity entity = create_with<C...>(C{}...);
        init(i, entity, *find_mutable<C>(entity)...);
    }
}

template <class... Terms> void World::destroy_matching(const Query<Terms...>& query) {
    std::vector<Entity> matches;
    for (auto it = query.begin(); it != query.end(); ++it) matches.push_back(it.entity());
    destroy_many(matches);
}

template <class C> C& World::assign(Entity entity, C value) {
    auto& store = stores_.ensure<C>();
    const std::uint32_t row = store.row(entity);
    if (row == detail::no_row) {
        lock_.assert_idle();
        return store.insert(entity, std::move(value), tick_);
    }
    store.value(row) = std::move(value);
    store.mark_changed(row, tick_);
    return store.value(row);
}

template <Component C> C& World::add(Entity entity, C value) {
    static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
    require_alive(entity);
    return assign<C>(entity, std::move(value));
}

template <Component C> bool World::remove(Entity entity) {
    static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
    if (!has<C>(entity)) return false;
    lock_.assert_idle();
    return stores_.find<C>()->erase(entity, tick_);
}

template <Component C> const C* World::find(Entity entity) const {
    const auto* store = stores_.find<C>();
    if (!store) return nullptr;
    const std::uint32_t row = store->row(entity);
    return row != detail::no_row ? &store->value(row) : nullptr;
}

template <Component C> C* World::find_mutable(Entity entity) {
    static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
    auto* store = stores_.find<C>();
    if (!store) return nullptr;
    const std::uint32_t row = store->row(entity);
    if (row == detail::no_row) return nullptr;
    store->mark_changed(row, tick_);
    return &store->value(row);
}

template <Component C> const C& World::get(Entity entity) const {
    if (const C* found = find<C>(entity)) return *found;
    throw_missing(entity, detail::type_name<C>());
}

template <Component C> C& World::get_mutable(Entity entity) {
    if (C* found = find_mutable<C>(entity)) return *found;
    throw_missing(entity, detail::type_name<C>());
}

template <Component C> bool World::set_if_different(Entity entity, const C& value) {
    if (const C* found = find<C>(entity); found && *found == value) return false;
    add<C>(entity, value);
    return true;
}

template <Component C> Tick World::changed_tick(Entity entity) const {
    const auto* store = stores_.find<C>();
    const std::uint32_t row = store ? store->row(entity) : detail::no_row;
    if (row == detail::no_row) throw_missing(entity, detail::type_name<C>());
    return store->changed(row);
}

template <Component C> Tick World::added_tick(Entity entity) const {
    const auto* store = stores_.find<C>();
    const std::uint32_t row = store ? store->row(entity) : detail::no_row;
    if (row == detail::no_row) throw_missing(entity, detail::type_name<C>());
    return store->added(row);
}

template <Component C> bool World::changed_since(Entity entity, Tick since) const {
    const auto* store = stores_.find<C>();
    const std::uint32_t row = store ? store->row(entity) : detail::no_row;
    return row != detail::no_row && store->changed(row) > since;
}

template <Component C> std::span<const Entity> World::removed_since(Tick since) const {
    const auto* store = stores_.find<C>();
    return store ? store->removed_since(since) : std::span<const Entity>{};
}

template <Component C> Tick World::last_changed() const {
    const auto* store = stores_.find<C>();
    return store ? store->last_changed() : 0;
}

template <class T> const T& World::resource() const {
    if (const T* found = find_resource<T>()) return *found;
    throw MissingResource(detail::type_name<T>());
}

template <class T> T& World::resource_mutable() {
    if (T* found = find_resource<T>()) return *found;
    throw MissingResource(detail::type_name<T>());
}

} // namespace hachure
