#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/systems/script/component_keys.h>
#include <hachure/systems/script/lua_binding.h>

#include <cstdint>

struct lua_State;

namespace hachure::script {

/// How many components an entity's value keeps at hand.
inline constexpr int kept_components = 3;

/// An entity as scripts hold it. The components that were asked for last are its user values.
struct EntityBox {
    BoxKind kind = BoxKind::entity;
    Entity entity;
    int next = 0; ///< of the kept components, which is replaced
    const ComponentKey* kept[kept_components] = {};
};

/// A component of an entity as scripts hold it: looked up each time it is used, since it may be gone by then.
struct ComponentBox {
    BoxKind kind = BoxKind::component;
    Entity entity;
    const ComponentKey* key = nullptr;
    const void* component = nullptr; ///< where it is, while `structure` is that of the context
    std::uint64_t structure = 0;
};

/// Pushes the entity; nil for null. The same entity is the same value.
void push_entity(lua_State* state, Entity entity);

/// The entity at `index`, or null.
[[nodiscard]] const EntityBox* entity_at(lua_State* state, int index);

/// The same; raises an error when there is none, or when it is not alive.
[[nodiscard]] Entity check_alive(lua_State* state, int index);

/// The reflected type that the text at `index` names; raises an error when there is none.
[[nodiscard]] const ComponentKey& check_component(lua_State* state, int index);

/// Pushes the component `key` of the entity at `index`.
void push_component(lua_State* state, int index, const ComponentKey& key);

/// Lets entities be forgotten that no script holds when memory gets short, and keeps them otherwise: making them anew
/// in each frame takes longer than all else. Call it in each frame.
void trim_entities(lua_State* state);

/// Makes the type of components known.
void open_components(lua_State* state);

/// Makes the type of entities known.
void open_entities(lua_State* state);

/// Makes the place where their values are kept.
void open_entity_cache(lua_State* state);

/// `e:add(name, fields)`; see docs/scripts.md.
int add_component(lua_State* state);

} // namespace hachure::script
