#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_machine.h>
#include <hachure/systems/script/sandbox.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/text_pattern.h>

#include <lua5.4/lua.hpp>

#include <cstring>
#include <string_view>

namespace hachure::script {
namespace {

/// What would be shown with its address, which differs from run to run.
bool shows_address(int type) {
    return type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TTHREAD || type == LUA_TLIGHTUSERDATA;
}

int to_string(lua_State* state) {
    luaL_checkany(state, 1);
    push_text(state, 1);
    return 1;
}

/// As the library's, without addresses; upvalue 1 is the library's.
int format(lua_State* state) {
    std::size_t size = 0;
    const char* const text = luaL_checklstring(state, 1, &size);
    const std::string_view pattern(text, size);
    for (std::size_t at = pattern.find('%'); at != pattern.npos; at = pattern.find('%', at)) {
        at = pattern.find_first_not_of("-+ #0123456789.", at + 1);
        if (at == pattern.npos) break;
        if (pattern[at++] == 'p') return luaL_error(state, "addresses are not for scripts");
    }
    for (int i = lua_gettop(state); i > 1; --i)
        if (shows_address(lua_type(state, i))) {
            push_text(state, i);
            lua_replace(state, i);
        }
    std::int64_t bytes = 0;
    for (int i = lua_gettop(state); i > 0; --i)
        if (lua_type(state, i) == LUA_TSTRING) bytes += static_cast<std::int64_t>(lua_rawlen(state, i));
    Machine::of(state).charge(state, bytes / 16);
    return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

/// As the library's, which would fill all memory before it found that the result is too long.
int repeat(lua_State* state) {
    std::size_t size = 0, between = 0;
    luaL_checklstring(state, 1, &size);
    const lua_Integer count = luaL_checkinteger(state, 2);
    luaL_optlstring(state, 3, "", &between);
    Machine& machine = Machine::of(state);
    const double bytes = count <= 0 ? 0.0 : static_cast<double>(count) * static_cast<double>(size + between);
    if (bytes > static_cast<double>(machine.limits().text)) return luaL_error(state, "resulting string too large");
    // An empty text can be repeated a lot; then that is what takes time.
    machine.charge(state, static_cast<std::int64_t>(bytes / 16.0));
    if (bytes == 0.0) return lua_pushliteral(state, ""), 1;
    machine.charge(state, count);
    return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

void open_strings(lua_State* state) {
    static constexpr const char* counted[] = {"byte", "char", "lower",  "upper",   "reverse",
                                              "sub",  "pack", "unpack", "packsize"};
    luaL_requiref(state, "string", luaopen_string, 0);
    lua_pushnil(state);
    lua_setfield(state, -2, "dump");
    for (const char* const name : counted) {
        lua_getfield(state, -1, name);
        push_counted(state, Cost::texts);
        lua_setfield(state, -2, name);
    }
    open_patterns(state);
    enclose(state, "format", format);
    enclose(state, "rep", repeat);
    // ("text"):upper() finds the same functions, and nothing that could be changed.
    lua_pushliteral(state, "");
    lua_getmetatable(state, -1);
    lua_pushvalue(state, -3);
    lua_setfield(state, -2, "__index");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_pop(state, 2);
    protect_table(state, "string");
    lua_setfield(state, -2, "string");
}

void open_utf8(lua_State* state) {
    luaL_requiref(state, "utf8", luaopen_utf8, 0);
    for (const char* const name : {"len", "codepoint", "offset", "codes", "char"}) {
        lua_getfield(state, -1, name);
        push_counted(state, Cost::texts);
        lua_setfield(state, -2, name);
    }
    protect_table(state, "utf8");
    lua_setfield(state, -2, "utf8");
}

} // namespace

const char* push_text(lua_State* state, int index) {
    index = lua_absindex(state, index);
    bool plain = !shows_address(lua_type(state, index));
    if (!plain && luaL_getmetafield(state, index, "__tostring") != LUA_TNIL) {
        lua_pop(state, 1);
        plain = true;
    }
    return plain ? luaL_tolstring(state, index, nullptr) : lua_pushstring(state, luaL_typename(state, index));
}

void open_texts(lua_State* state) {
    lua_pushcfunction(state, to_string);
    lua_setfield(state, -2, "tostring");
    luaL_requiref(state, "_G", luaopen_base, 0);
    lua_getfield(state, -1, "tonumber");
    push_counted(state, Cost::texts);
    lua_setfield(state, -3, "tonumber");
    lua_pop(state, 1);
    open_strings(state);
    open_utf8(state);
}

} // namespace hachure::script
