#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_machine.h>
#include <hachure/systems/script/sandbox.h>
#include <hachure/systems/script/script_api.h>

#include <lua5.4/lua.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace hachure::script {
namespace {

constexpr std::int64_t table_bytes_per_step = 16;
constexpr std::int64_t too_many = std::numeric_limits<std::int64_t>::max() / 4;

std::int64_t length(lua_State* state, int index) { return static_cast<std::int64_t>(lua_rawlen(state, index)); }

std::int64_t cost_of_texts(lua_State* state) {
    std::int64_t bytes = 0;
    for (int i = lua_gettop(state); i > 0; --i)
        if (lua_type(state, i) == LUA_TSTRING) bytes += length(state, i);
    return bytes / table_bytes_per_step;
}

/// How many elements the integers at `first` and after it span.
std::int64_t cost_of_range(lua_State* state, int first, std::int64_t size) {
    const lua_Integer begin = luaL_optinteger(state, first, 1), end = luaL_optinteger(state, first + 1, size);
    if (end < begin) return 0;
    const std::uint64_t count = static_cast<std::uint64_t>(end) - static_cast<std::uint64_t>(begin);
    return static_cast<std::int64_t>(std::min<std::uint64_t>(count, static_cast<std::uint64_t>(too_many)));
}

/// Texts of a list are compared letter by letter.
std::int64_t cost_of_sorting(lua_State* state, std::int64_t size) {
    std::int64_t longest = 0;
    for (lua_Integer i = 1; i <= size; ++i) {
        if (lua_rawgeti(state, 1, i) == LUA_TSTRING) longest = std::max(longest, length(state, -1));
        lua_pop(state, 1);
    }
    const std::int64_t comparisons = size * static_cast<std::int64_t>(std::bit_width(static_cast<std::uint64_t>(size)));
    return size + 2 * comparisons * (1 + longest / table_bytes_per_step);
}

std::int64_t cost_of_list(lua_State* state, Cost cost) {
    luaL_checktype(state, 1, LUA_TTABLE);
    // It could say anything, and something else when the library asks again.
    if (luaL_getmetafield(state, 1, "__len") != LUA_TNIL) luaL_error(state, "a list with a length of its own");
    const std::int64_t size = length(state, 1);
    const int arguments = lua_gettop(state);
    switch (cost) {
    case Cost::insert:
        return arguments > 2 ? size : 0;
    case Cost::remove:
        return arguments > 1 ? size : 0;
    case Cost::concat:
        return cost_of_range(state, 3, size);
    case Cost::unpack:
    case Cost::move:
        return cost_of_range(state, 2, size);
    default:
        return cost_of_sorting(state, size);
    }
}

/// Upvalue 1: the function of the library; upvalue 2: its Cost.
int counted(lua_State* state) {
    const auto cost = static_cast<Cost>(lua_tointeger(state, lua_upvalueindex(2)));
    Machine::of(state).charge(state, cost == Cost::texts ? cost_of_texts(state) : cost_of_list(state, cost));
    return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

/// What could run or go at a time that nobody can tell: on the collector's.
int set_metatable(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_argexpected(state, lua_isnoneornil(state, 2) || lua_istable(state, 2), 2, "nil or table");
    lua_settop(state, 2);
    if (luaL_getmetafield(state, 1, "__metatable") != LUA_TNIL)
        return luaL_error(state, "cannot change a protected metatable");
    for (const char* const name : {"__gc", "__mode"}) {
        if (lua_isnil(state, 2)) break;
        lua_pushstring(state, name);
        if (lua_rawget(state, 2) != LUA_TNIL) return luaL_error(state, "a script can't set %s", name);
        lua_pop(state, 1);
    }
    lua_settop(state, 2);
    lua_setmetatable(state, 1);
    return 1;
}

int raw_set(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_checkany(state, 3);
    lua_settop(state, 3);
    if (luaL_getmetafield(state, 1, "__metatable") != LUA_TNIL) return luaL_error(state, "the table is protected");
    lua_rawset(state, 1);
    return 1;
}

int collect_garbage(lua_State* state) {
    static constexpr const char* options[] = {"collect", "count", nullptr};
    const bool count = luaL_checkoption(state, 1, "collect", options) == 1;
    Machine& machine = Machine::of(state);
    if (count) return lua_pushnumber(state, static_cast<double>(machine.memory()) / 1024.0), 1;
    machine.charge(state, static_cast<std::int64_t>(machine.memory()) / table_bytes_per_step);
    lua_gc(state, LUA_GCCOLLECT);
    lua_pushinteger(state, 0);
    return 1;
}

constexpr NamedFunction table_functions[] = {
    {"setmetatable", set_metatable}, {"rawset", raw_set}, {"collectgarbage", collect_garbage}, {nullptr, nullptr}};

} // namespace

void push_counted(lua_State* state, Cost cost) {
    lua_pushinteger(state, static_cast<lua_Integer>(cost));
    lua_pushcclosure(state, counted, 2);
}

void open_tables(lua_State* state) {
    static constexpr struct {
        const char* name;
        Cost cost;
    } costs[] = {{"insert", Cost::insert}, {"remove", Cost::remove}, {"concat", Cost::concat},
                 {"unpack", Cost::unpack}, {"move", Cost::move},     {"sort", Cost::sort}};
    set_functions(state, table_functions);
    luaL_requiref(state, "table", luaopen_table, 0);
    for (const auto& [name, cost] : costs) {
        lua_getfield(state, -1, name);
        push_counted(state, cost);
        lua_setfield(state, -2, name);
    }
    protect_table(state, "table");
    lua_setfield(state, -2, "table");
}

} // namespace hachure::script
