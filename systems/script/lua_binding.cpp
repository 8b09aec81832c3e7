#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {

void keep_fault(lua_State* state, const char* message) noexcept {
    try {
        context_of(state).fault = message;
    } catch (...) {
    } // the one before is as good as any when memory ends
}

int raise_fault(lua_State* state) {
    const std::string& fault = context_of(state).fault;
    luaL_where(state, 1);
    lua_pushlstring(state, fault.data(), fault.size());
    lua_concat(state, 2);
    return lua_error(state);
}

void* box_at(lua_State* state, int index, BoxKind kind) {
    if (lua_type(state, index) != LUA_TUSERDATA) return nullptr;
    void* const box = lua_touserdata(state, index);
    return *static_cast<const BoxKind*>(box) == kind ? box : nullptr;
}

std::string_view check_text(lua_State* state, int index) {
    std::size_t length = 0;
    const char* const text = luaL_checklstring(state, index, &length);
    return {text, length};
}

void set_functions(lua_State* state, const NamedFunction* functions) {
    for (; functions->name; ++functions) {
        lua_pushcfunction(state, functions->function);
        lua_setfield(state, -2, functions->name);
    }
}

void enclose(lua_State* state, const char* name, int (*around)(lua_State*)) {
    lua_getfield(state, -1, name);
    lua_pushcclosure(state, around, 1);
    lua_setfield(state, -2, name);
}

void push_metatable(lua_State* state, const char* name, const NamedFunction* functions) {
    lua_newtable(state);
    set_functions(state, functions);
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_pushstring(state, name);
    lua_setfield(state, -2, "__name");
}

} // namespace hachure::script
