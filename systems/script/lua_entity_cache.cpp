// The values of entities that scripts hold, one for each entity, so that the same entity is the same value.

#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

#include <new>

namespace hachure::script {
namespace {

bool is_short_of_memory(const Context& context) {
    return !context.forgetful && context.machine->memory() > context.machine->limits().memory / 2;
}

void set_forgetful(lua_State* state, bool forgetful) {
    Context& context = context_of(state);
    lua_rawgeti(state, LUA_REGISTRYINDEX, context.entity_cache);
    if (forgetful)
        lua_rawgeti(state, LUA_REGISTRYINDEX, context.weak_table);
    else
        lua_pushnil(state);
    lua_setmetatable(state, -2);
    lua_pop(state, 1);
    context.forgetful = forgetful;
}

} // namespace

void push_entity(lua_State* state, Entity entity) {
    if (!entity) return lua_pushnil(state);
    const Context& context = context_of(state);
    const auto slot = static_cast<lua_Integer>(entity.index) + 1;
    lua_rawgeti(state, LUA_REGISTRYINDEX, context.entity_cache);
    if (lua_rawgeti(state, -1, slot) == LUA_TUSERDATA &&
        static_cast<const EntityBox*>(lua_touserdata(state, -1))->entity == entity) {
        lua_remove(state, -2);
        return;
    }
    lua_pop(state, 1);
    if (is_short_of_memory(context)) set_forgetful(state, true);
    new (lua_newuserdatauv(state, sizeof(EntityBox), kept_components)) EntityBox{.entity = entity};
    lua_rawgeti(state, LUA_REGISTRYINDEX, context.entity_methods);
    lua_setmetatable(state, -2);
    lua_pushvalue(state, -1);
    lua_rawseti(state, -3, slot);
    lua_remove(state, -2);
}

void trim_entities(lua_State* state) {
    const Context& context = context_of(state);
    if (context.forgetful && context.machine->memory() < context.machine->limits().memory / 4)
        set_forgetful(state, false);
    else if (is_short_of_memory(context))
        set_forgetful(state, true);
}

void open_entity_cache(lua_State* state) {
    Context& context = context_of(state);
    lua_newtable(state);
    lua_pushliteral(state, "v");
    lua_setfield(state, -2, "__mode");
    context.weak_table = luaL_ref(state, LUA_REGISTRYINDEX);
    lua_newtable(state);
    context.entity_cache = luaL_ref(state, LUA_REGISTRYINDEX);
}

} // namespace hachure::script
