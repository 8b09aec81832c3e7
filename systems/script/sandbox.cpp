#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/lua_vector.h>
#include <hachure/systems/script/sandbox.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {
namespace {

int no_shared_assignment(lua_State* state) {
    return luaL_error(state, "what belongs to all scripts can't be assigned");
}

/// Copies the functions `names` (null-terminated) from the table below the top into that on top.
void copy_functions(lua_State* state, const char* const* names) {
    for (; *names; ++names) {
        lua_getfield(state, -2, *names);
        lua_setfield(state, -2, *names);
    }
}

void open_base(lua_State* state) {
    static constexpr const char* harmless[] = {"assert", "error",  "getmetatable", "ipairs",   "rawequal", "rawget",
                                               "rawlen", "select", "type",         "_VERSION", nullptr};
    luaL_requiref(state, "_G", luaopen_base, 0);
    lua_pushvalue(state, -2);
    copy_functions(state, harmless);
    lua_pop(state, 2);
}

/// All of it, with the random numbers of the house.
void open_math(lua_State* state) {
    luaL_requiref(state, "math", luaopen_math, 0);
    lua_getfield(state, -2, "random");
    lua_setfield(state, -2, "random");
    lua_pushnil(state);
    lua_setfield(state, -2, "randomseed");
    protect_table(state, "math");
    lua_setfield(state, -2, "math");
}

} // namespace

void protect_table(lua_State* state, const char* name) {
    static constexpr NamedFunction refusal[] = {{"__newindex", no_shared_assignment}, {nullptr, nullptr}};
    lua_newtable(state);
    push_metatable(state, name, refusal);
    lua_pushvalue(state, -3);
    lua_setfield(state, -2, "__index");
    lua_setmetatable(state, -2);
    lua_replace(state, -2);
}

void open_sandbox(lua_State* state) {
    lua_newtable(state);
    open_base(state);
    open_calls(state);
    open_texts(state);
    open_tables(state);
    open_order(state);
    open_random(state);
    open_math(state);
    open_vectors(state);
    open_components(state);
    open_entities(state);
    open_scene(state);
    open_frame(state);
    context_of(state).globals = luaL_ref(state, LUA_REGISTRYINDEX);
    // Lua's own globals, which no script has to do with.
    lua_newtable(state);
    lua_rawseti(state, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
}

} // namespace hachure::script
