#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/tests/runtime/ecs/world_model/model_components.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace hachure::test::model {

/// One component of an entity.
struct Cell {
    std::uint32_t number; ///< as the component's `number()` gives it
    Tick added;
    Tick changed;
};

/// One entity.
struct Node {
    std::array<std::optional<Cell>, kinds> cells; ///< by kind
    Entity parent;
    std::vector<Entity> children;

    template <class... C> bool has_all() const { return (cells[kind_of<C>].has_value() && ...); }
    template <class... C> bool has_any() const { return (cells[kind_of<C>].has_value() || ...); }
    template <class C> bool changed_since(Tick since) const {
        return has_all<C>() && cells[kind_of<C>]->changed > since;
    }
    template <class C> bool added_since(Tick since) const { return has_all<C>() && cells[kind_of<C>]->added > since; }
};

/// One component that an entity lost.
struct Removal {
    int kind;
    Entity entity;
    Tick tick;
};

/// What a world is supposed to be, without any care for speed. Entities that are asked for must be alive.
class WorldModel {
public:
    std::map<Entity, Node> nodes;
    std::vector<Removal> removals;
    Tick tick = 1;

    bool alive(Entity entity) const { return nodes.contains(entity); }
    bool has(Entity entity, int kind) const;
    std::vector<Entity> entities() const;

    /// Adds the component, or writes to the one that is there.
    void put(Entity entity, int kind, std::uint32_t number);
    template <class C> void put(Entity entity, std::uint32_t number) {
        put(entity, kind_of<C>, C::make(number).number());
    }

    void remove(Entity entity, int kind);
    void destroy(Entity entity);
    void clear();

    /// Whether `entity` is `ancestor` or below it.
    bool contains(Entity ancestor, Entity entity) const;
    void link(Entity entity, Entity parent);
    void unlink(Entity entity);

    void forget_removed_before(Tick before);
};

} // namespace hachure::test::model
