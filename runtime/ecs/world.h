#pragma once

#include <hachure/runtime/ecs/ecs_error.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/entity_map.h>
#include <hachure/runtime/ecs/hierarchy.h>
#include <hachure/runtime/ecs/query.h>
#include <hachure/runtime/ecs/resources.h>
#include <hachure/runtime/ecs/storage.h>
#include <hachure/runtime/ecs/storage/entity_store.h>
#include <hachure/runtime/ecs/tick.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace hachure {

class Commands;

/// Entities, their components, their tree, and one resource per type.
///
/// A structural change is: creating or destroying an entity, adding a component to an entity that lacks it, removing
/// one that is there, and changing the tree. It ends the validity of every component reference, pointer and span that
/// the world gave out, and it asserts while a query is walked (queue it in `commands()` instead).
///
/// Reading a constant world from several threads is safe; everything else is for one thread at a time. The order in
/// which queries visit depends only on the calls made so far. A world that was moved from can only be destroyed or
/// assigned to.
class World {
public:
    World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    // Entities.

    Entity create();

    /// Creates an entity with these components.
    template <Component... C> Entity create_with(C... components);

    /// Creates `count` entities with these components; each starts as a copy of the one given.
    template <Component... C> std::vector<Entity> create_many(std::size_t count, const C&... components);

    /// Creates `count` entities with default-constructed C..., and calls `init(i, entity, C&...)` for each, i from 0.
    /// It touches no components but those: entities that follow are not whole yet, and changing the structure asserts.
    /// When it throws, those that it was called for stay.
    template <Component... C, class F> void create_each(std::size_t count, F&& init);

    /// Destroys an entity with all its descendants; false when it is dead already.
    bool destroy(Entity entity);

    /// Destroys those that are alive, with their descendants.
    void destroy_many(std::span<const Entity> entities);

    /// Destroys all entities that the query matches, with their descendants.
    template <class... Terms> void destroy_matching(const Query<Terms...>& query);

    /// Destroys all entities.
    void clear();

    /// Which handles are alive and which come next.
    EntityIds entity_ids() const;

    /// Destroys all entities, then makes exactly those of `ids` alive, without components; later creations give the
    /// same handles as in the world that `ids` came from.
    void restore_entities(const EntityIds& ids);

    bool alive(Entity entity) const { return store_->ids().alive(entity); }

    /// Copies `prefab` with all its descendants: their components (those that can be copied), their tree, and none of
    /// their ties to the outside; the copy of `prefab` is a root. A component that refers to entities says how it
    /// follows to the copies: see `EntityMap`. Returns the copy of `prefab`. Throws DeadEntity.
    Entity instantiate(Entity prefab);

    /// The same `count` times.
    std::vector<Entity> instantiate_many(Entity prefab, std::size_t count);

    /// How many entities are alive.
    std::size_t size() const { return store_->ids().alive_count(); }

    // Components. Throw DeadEntity and MissingComponent where a live entity, or one that has C, is required.

    /// Gives `entity` a C. Where it has one already the value is replaced, which is a change and no structural one.
    /// Throws DeadEntity.
    template <Component C> C& add(Entity entity, C value = {});

    /// Takes C off `entity`; false when it has none or is dead.
    template <Component C> bool remove(Entity entity);

    template <Component C> bool has(Entity entity) const { return find<C>(entity) != nullptr; }

    /// Throws DeadEntity, MissingComponent.
    template <Component C> const C& get(Entity entity) const;

    /// Several at once, for little more than one: `const auto [position, velocity] = world.get<Position, Velocity>(e)`.
    template <Component... C>
    requires(sizeof...(C) > 1) std::tuple<const C&...> get(Entity entity)
    const;

    /// The same to write; marks it changed.
    template <Component C> C& get_mutable(Entity entity);

    /// Null when the entity is dead or has no C.
    template <Component C> const C* find(Entity entity) const;

    /// The same to write; marks it changed.
    template <Component C> C* find_mutable(Entity entity);

    /// Makes C of `entity` equal to `value`: adds it where it is absent, and changes (and marks) it only where it
    /// differs. True when anything was done. Throws DeadEntity.
    template <Component C> bool set_if_different(Entity entity, const C& value);

    // Queries; see `Query`. A constant world offers the terms that only read.

    template <class... Terms> Query<Terms...> query() { return Query<Terms...>(*store_); }
    template <class... Terms>
    requires(!detail::Term<Terms>::writes && ...) auto query() const { return Query<Terms...>(*store_); }

    // Change ticks; see `Tick`.

    /// The current tick; 1 in a new world.
    Tick tick() const { return store_->tick(); }

    /// Begins the next tick and returns it. Not while a query is walked.
    Tick advance_tick();

    /// When C of `entity` was last added or changed. Throws DeadEntity, MissingComponent.
    template <Component C> Tick changed_tick(Entity entity) const;

    /// When C of `entity` was added. Throws DeadEntity, MissingComponent.
    template <Component C> Tick added_tick(Entity entity) const;

    /// Whether C of `entity` was added or changed after tick `since`; false when the entity is dead or has no C.
    template <Component C> bool changed_since(Entity entity, Tick since) const;

    /// The entities that lost C after tick `since`, by removal or by being destroyed, in order of time; once per loss.
    /// They may be dead, or have a C again.
    template <Component C> std::vector<Entity> removed_since(Tick since) const;

    /// Forgets removals made before `tick`. Without it the memory of removals grows; `Schedule::run` calls it.
    void forget_removed_before(Tick tick);

    /// When any C of any entity was last added, changed or removed; 0 for never. Constant time: a system compares it
    /// with the tick in which it last ran and skips all its work.
    template <Component C> Tick last_changed() const;

    // Observers: functions that are told at once what others learn from ticks. They may read and write components and
    // queue commands; changing the structure asserts.

    /// Calls `f(world, entity)` whenever an entity has got a C, with the value in place.
    template <Component C> void on_add(std::function<void(World&, Entity)> f);

    /// Calls `f(world, entity)` whenever an entity is about to lose a C, by removal or by being destroyed, with the
    /// value still there. Not at the end of the world.
    template <Component C> void on_remove(std::function<void(World&, Entity)> f);

    // The tree. `Parent` and `Children` can be queried as any component.

    /// Makes `child` the last child of `parent`; does nothing when it is a child of it already. Throws DeadEntity when
    /// either is dead and HierarchyCycle when `parent` is `child` or a descendant of it; nothing has changed then.
    void set_parent(Entity child, Entity parent);

    /// Makes `child` a root; does nothing when it is one or is dead.
    void clear_parent(Entity child);

    /// The parent, or null for a root or a dead entity.
    Entity parent(Entity entity) const;

    /// The children in order of insertion; empty for a leaf or a dead entity. Holds until the next structural change.
    std::span<const Entity> children(Entity entity) const;

    /// All descendants without `entity` itself: parents before children, siblings in order.
    std::vector<Entity> descendants(Entity entity) const;

    /// Calls `f(Entity)` for each of `descendants(entity)`. They are collected beforehand, so f may change the world.
    template <class F> void for_each_descendant(Entity entity, F&& f) const {
        for (const Entity descendant : descendants(entity)) f(descendant);
    }

    // Resources: one value per type, for what belongs to no entity. They may be move-only. A resource stays where it
    // is until it is set again or removed, whatever happens to entities.

    /// Sets or replaces the resource of type T.
    template <class T> T& set_resource(T value) { return resources_.set<T>(std::move(value)); }

    /// Throws MissingResource.
    template <class T> const T& resource() const;
    template <class T> T& resource_mutable();

    /// Null when there is none.
    template <class T> const T* find_resource() const { return resources_.find<T>(); }
    template <class T> T* find_resource() { return resources_.find<T>(); }

    /// False when there is none.
    template <class T> bool remove_resource() { return resources_.remove<T>(); }

    // Deferred changes; include commands.h to use them.

    /// The world's own queue. `Schedule` applies it after each system.
    Commands& commands() { return *commands_; }

    /// Applies and empties the world's own queue; see `Commands::apply`.
    void apply_commands();

    /// For systems: as `query`, marking what is written in tick `now`.
    template <class... Terms> Query<Terms...> query_at(Tick now) { return Query<Terms...>(*store_, now); }

private:
    friend class Commands;

    void require_alive(Entity entity) const;
    [[noreturn, gnu::cold]] void throw_missing(Entity entity, std::string_view component) const;

    /// Unchecked: neither whether the world itself manages C, nor whether the entity lives.
    template <class C> C& assign(Entity entity, C value);
    template <class C> bool erase(Entity entity);
    template <class C> C& write(Entity entity);
    template <class... C, class Make, class F> void create_rows(std::size_t count, Make&& make, F&& init);
    template <class... C, class Make, class F> void create_row(std::size_t i, Make& make, F& init);
    template <class... C, class Make, class F>
    std::size_t fill_rows(detail::Table& table, std::size_t done, std::size_t count, Make& make, F& init);

    void notify(const std::deque<detail::Observer>& observers, Entity entity);
    void notify_added(Entity entity);
    void notify_added(std::span<const Entity> entities);
    void notify_removed(Entity entity);
    void destroy_tables(const std::vector<detail::Table*>& tables);
    void revive(Entity reserved);
    void detach(Entity child);
    Entity copy_entity(Entity from, bool with_tree);

    std::unique_ptr<detail::EntityStore> store_;
    detail::Resources resources_;
    std::unique_ptr<Commands> commands_;
    bool observed_ = false; ///< there are observers
};

} // namespace hachure

#include <hachure/runtime/ecs/world_inline.h>
