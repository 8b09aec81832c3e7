#pragma once

// The templates of world.h, which includes this.

#include <hachure/runtime/ecs/world.h>

#include <concepts>
#include <cstddef>
#include <memory>
#include <new>
#include <tuple>
#include <utility>

namespace hachure {

template <Component... C> Entity World::create_with(C... components) {
    static_assert((!detail::managed_by_world<C> && ...),
                  "Parent and Children change through set_parent and clear_parent");
    static_assert(detail::distinct<C...>, "an entity has one component of a type");
    store_->lock().assert_idle();
    const Entity entity = store_->create(store_->table_for<C...>());
    const detail::Location row = store_->ids().find(entity);
    (store_->emplace<C>(entity, row, store_->record<C>(), std::move(components)), ...);
    if (observed_) notify_added(entity);
    return entity;
}

template <Component... C> std::vector<Entity> World::create_many(std::size_t count, const C&... components) {
    std::vector<Entity> result;
    result.reserve(count);
    create_rows<C...>(
        count, [&](C*... places) { (new (places) C(components), ...); },
        [&](std::size_t, Entity entity, C&...) { result.push_back(entity); });
    return result;
}

template <Component... C, class F> void World::create_each(std::size_t count, F&& init) {
    create_rows<C...>(
        count, [](C*... places) { (new (places) C{}, ...); }, init);
}

template <class... C, class Make, class F> void World::create_rows(std::size_t count, Make&& make, F&& init) {
    static_assert(detail::distinct<C...>, "an entity has one component of a type");
    static_assert((!detail::managed_by_world<C> && ...),
                  "Parent and Children change through set_parent and clear_parent");
    store_->lock().assert_idle();
    // Not by `init`, either: rows that follow hold no values yet.
    const detail::IterationLock::Guard guard(store_->lock());
    if constexpr ((detail::is_sparse<C> || ...)) {
        for (std::size_t i = 0; i < count; ++i) create_row<C...>(i, make, init);
    } else {
        detail::Table& table = store_->table_for<C...>();
        for (std::size_t done = 0; done < count;) done += fill_rows<C...>(table, done, count, make, init);
    }
}

template <class... C, class Make, class F> void World::create_row(std::size_t i, Make& make, F& init) {
    detail::EntityStore& store = *store_;
    // Raw memory for each component, filled as in a table, then moved to where it belongs.
    std::tuple<detail::Raw<C>...> raw;
    make(std::get<detail::Raw<C>>(raw).place()...);
    const Entity entity = store.create(store.table_for<C...>());
    const detail::Location row = store.ids().find(entity);
    const std::tuple<C&...> values{
        store.emplace<C>(entity, row, store.record<C>(), std::move(*std::get<detail::Raw<C>>(raw).place()))...};
    (std::destroy_at(std::get<detail::Raw<C>>(raw).place()), ...);
    try {
        init(i, entity, std::get<C&>(values)...);
    } catch (...) {
        if (observed_) notify_added(entity);
        throw;
    }
    if (observed_) notify_added(entity);
}

template <class... C, class Make, class F>
std::size_t World::fill_rows(detail::Table& table, std::size_t done, std::size_t count, Make& make, F& init) {
    detail::EntityStore& store = *store_;
    const auto rows = store.create_rows(table, count - done, tick());
    [[maybe_unused]] std::byte* const data = store.chunks()[rows.first.chunk()].data;
    const Entity* entities = table.entities(rows.first.chunk()).data() + rows.first.row();
    std::uint32_t made = 0;
    const auto fill = [&](C*... columns) {
        for (std::uint32_t i = 0; i < rows.count; ++i) {
            make(detail::step(columns, i)...);
            ++made;
            init(done + i, entities[i], *detail::step(columns, i)...);
        }
    };
    try {
        fill(detail::step(reinterpret_cast<C*>(data + table.offset(detail::component_id<C>())), rows.first.row())...);
    } catch (...) {
        store.drop_raw_rows(rows, made);
        if (observed_) notify_added({entities, made});
        throw;
    }
    if (observed_) notify_added({entities, made});
    return rows.count;
}

template <class... Terms> void World::destroy_matching(const Query<Terms...>& query) {
    if (const auto* tables = query.whole_tables()) return destroy_tables(*tables);
    std::vector<Entity> matches;
    for (auto it = query.begin(); it != query.end(); ++it) matches.push_back(it.entity());
    destroy_many(matches);
}

template <class C> C& World::assign(Entity entity, C value) {
    detail::EntityStore& store = *store_;
    detail::Location row = store.ids().find(entity);
    detail::Location at;
    if (C* found = store.find_at<C>(entity, row, at)) {
        *found = std::move(value);
        store.mark(detail::component_id<C>(), entity, at, store.tick());
        return *found;
    }
    store.lock().assert_idle();
    detail::ComponentRecord& component = store.record<C>();
    if constexpr (!detail::is_sparse<C>) row = store.move_adding(entity, row, component);
    C& result = store.emplace<C>(entity, row, component, std::move(value));
    if (!component.added.empty()) notify(component.added, entity);
    return result;
}

template <class C> bool World::erase(Entity entity) {
    const detail::Location row = store_->ids().find(entity);
    const detail::Location at = row ? store_->locate<C>(entity, row) : row;
    if (!at) return false;
    store_->lock().assert_idle();
    detail::ComponentRecord& component = store_->record<C>();
    if (!component.removed.empty()) notify(component.removed, entity);
    if constexpr (detail::is_sparse<C>)
        store_->remove_sparse(entity, at, component);
    else
        store_->remove(entity, at, component);
    return true;
}

template <Component C> C& World::add(Entity entity, C value) {
    static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
    if (!alive(entity)) throw_missing(entity, {});
    return assign<C>(entity, std::move(value));
}

template <Component C> bool World::remove(Entity entity) {
    static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
    return erase<C>(entity);
}

template <Component C> const C* World::find(Entity entity) const {
    detail::Location at;
    return store_->find<C>(entity, at);
}

template <Component C> C* World::find_mutable(Entity entity) {
    static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
    detail::Location at;
    C* found = store_->find<C>(entity, at);
    if (found) store_->mark(detail::component_id<C>(), entity, at, store_->tick());
    return found;
}

template <Component C> const C& World::get(Entity entity) const {
    if (const C* found = find<C>(entity)) return *found;
    throw_missing(entity, detail::type_name_of<C>);
}

template <Component... C>
requires(sizeof...(C) > 1) std::tuple<const C&...> World::get(Entity entity)
const { return {get<C>(entity)...}; }

template <Component C> C& World::get_mutable(Entity entity) {
    if (C* found = find_mutable<C>(entity)) return *found;
    throw_missing(entity, detail::type_name_of<C>);
}

template <Component C> bool World::set_if_different(Entity entity, const C& value) {
    if (const C* found = find<C>(entity); found && *found == value) return false;
    add<C>(entity, value);
    return true;
}

template <Component C> Tick World::changed_tick(Entity entity) const {
    if (!has<C>(entity)) throw_missing(entity, detail::type_name_of<C>);
    return store_->changed(detail::component_id<C>(), entity);
}

template <Component C> Tick World::added_tick(Entity entity) const {
    if (!has<C>(entity)) throw_missing(entity, detail::type_name_of<C>);
    return store_->added(detail::component_id<C>(), entity);
}

template <Component C> bool World::changed_since(Entity entity, Tick since) const {
    return store_->changed(detail::component_id<C>(), entity) > since;
}

template <Component C> std::vector<Entity> World::removed_since(Tick since) const {
    return store_->removals().since(detail::component_id<C>(), since);
}

template <Component C> Tick World::last_changed() const {
    const auto* component = store_->find_record(detail::component_id<C>());
    return component ? component->log.last_changed() : 0;
}

template <Component C> void World::on_add(std::function<void(World&, Entity)> f) {
    store_->record<C>().added.push_back(std::move(f));
    observed_ = true;
    store_->update_observed();
}

template <Component C> void World::on_remove(std::function<void(World&, Entity)> f) {
    store_->record<C>().removed.push_back(std::move(f));
    observed_ = true;
    store_->update_observed();
}

template <class T> const T& World::resource() const {
    if (const T* found = find_resource<T>()) return *found;
    throw MissingResource(detail::type_name_of<T>);
}

template <class T> T& World::resource_mutable() {
    if (T* found = find_resource<T>()) return *found;
    throw MissingResource(detail::type_name_of<T>);
}

} // namespace hachure
