// pairs and next that walk tables in an order which is the same in every run. Lua's own depends on hash seeds and
// addresses: numbers come first, then texts, booleans, entities.

#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/lua_machine.h>
#include <hachure/systems/script/lua_vector.h>
#include <hachure/systems/script/sandbox.h>

#include <lua5.4/lua.hpp>

#include <algorithm>
#include <compare>
#include <new>
#include <string_view>

namespace hachure::script {
namespace {

enum class Rank { number, text, boolean, entity, vector, component, other };

/// A key as it is compared; texts hold while the table does.
struct Key {
    Rank rank = Rank::other;
    double number = 0;
    lua_Integer integer = 0;
    bool whole = true; ///< `integer` says it exactly
    std::string_view text;
    Entity entity;
    const VectorBox* vector = nullptr;
    lua_Integer place = 0; ///< in the list of keys
};

Key key_at(lua_State* state, int index) {
    Key key;
    switch (lua_type(state, index)) {
    case LUA_TNUMBER:
        key.rank = Rank::number;
        key.number = lua_tonumber(state, index);
        key.integer = lua_tointeger(state, index);
        key.whole = lua_isinteger(state, index);
        break;
    case LUA_TSTRING: {
        std::size_t length = 0;
        const char* const text = lua_tolstring(state, index, &length);
        key.rank = Rank::text;
        key.text = {text, length};
        break;
    }
    case LUA_TBOOLEAN:
        key.rank = Rank::boolean;
        key.number = lua_toboolean(state, index);
        break;
    default:
        if (const EntityBox* const entity = entity_at(state, index)) {
            key.rank = Rank::entity;
            key.entity = entity->entity;
        } else if ((key.vector = vector_at(state, index))) {
            key.rank = Rank::vector;
        } else if (const void* const box = box_at(state, index, BoxKind::component)) {
            const auto& component = *static_cast<const ComponentBox*>(box);
            key.rank = Rank::component;
            key.entity = component.entity;
            key.text = component.key->type->name;
        }
    }
    return key;
}

bool comes_before(const Key& a, const Key& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    if (a.rank == Rank::number && a.whole && b.whole) return a.integer < b.integer;
    if (a.number != b.number) return a.number < b.number;
    if (a.whole != b.whole) return a.whole; // 2^63 comes after all integers, the largest of which rounds to it
    if (a.vector && b.vector && a.vector->kind != b.vector->kind) return a.vector->kind < b.vector->kind;
    if (a.vector && b.vector)
        return std::lexicographical_compare(a.vector->at, a.vector->at + 4, b.vector->at, b.vector->at + 4);
    if (a.entity != b.entity) return a.entity < b.entity;
    return a.text < b.text;
}

void check_order(lua_State* state, const Key* keys, std::size_t count) {
    if (count > 1 && keys[count - 2].rank == Rank::other)
        luaL_error(state, "keys that are tables or functions have no order");
}

/// Upvalues: keys in order, how many, the place of the last one given.
int next_pair(lua_State* state) {
    const lua_Integer count = lua_tointeger(state, lua_upvalueindex(2));
    lua_Integer at = lua_tointeger(state, lua_upvalueindex(3));
    while (++at <= count) {
        lua_rawgeti(state, lua_upvalueindex(1), at);
        lua_pushvalue(state, -1);
        if (lua_rawget(state, 1) == LUA_TNIL) { // removed since
            lua_pop(state, 2);
            continue;
        }
        lua_pushinteger(state, at);
        lua_replace(state, lua_upvalueindex(3));
        return 2;
    }
    return 0;
}

lua_Integer count_keys(lua_State* state, int table) {
    lua_Integer count = 0;
    for (lua_pushnil(state); lua_next(state, table); lua_pop(state, 1)) ++count;
    return count;
}

/// Pushes a list of the keys of the table at 1, in order.
void push_keys(lua_State* state, lua_Integer count) {
    lua_createtable(state, static_cast<int>(count), 0);
    const int list = lua_gettop(state);
    auto* const keys = static_cast<Key*>(lua_newuserdatauv(state, static_cast<std::size_t>(count) * sizeof(Key), 0));
    lua_Integer n = 0;
    for (lua_pushnil(state); lua_next(state, 1); lua_pop(state, 1)) {
        new (keys + n) Key(key_at(state, -2));
        keys[n].place = n + 1;
        ++n;
        lua_pushvalue(state, -2);
        lua_rawseti(state, list, n);
    }
    if (!std::is_sorted(keys, keys + n, comes_before)) {
        std::sort(keys, keys + n, comes_before);
        lua_createtable(state, static_cast<int>(count), 0);
        for (lua_Integer i = 0; i < n; ++i) {
            lua_rawgeti(state, list, keys[i].place);
            lua_rawseti(state, -2, i + 1);
        }
        lua_replace(state, list);
    }
    check_order(state, keys, static_cast<std::size_t>(n));
    lua_settop(state, list);
}

int pairs(lua_State* state) {
    luaL_checkany(state, 1);
    if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(state, 1);
        lua_call(state, 1, 3);
        return 3;
    }
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 1);
    const lua_Integer count = count_keys(state, 1);
    Machine::of(state).charge(state, 8 * count);
    push_keys(state, count);
    lua_pushinteger(state, count);
    lua_pushinteger(state, 0);
    lua_pushcclosure(state, next_pair, 3);
    lua_pushvalue(state, 1);
    return 2;
}

/// The least key that comes after the one given. It looks at all of them, so it is no way to walk a large table.
int next(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 2);
    const bool first = lua_isnil(state, 2);
    const Key after = key_at(state, 2);
    Key best;
    std::int64_t steps = 0;
    bool found = false, unordered = !first && after.rank == Rank::other;
    lua_pushnil(state);
    lua_pushnil(state); // the best key so far, at 3
    for (; lua_next(state, 1); lua_pop(state, 1)) {
        ++steps;
        const Key key = key_at(state, -2);
        if (!first && !comes_before(after, key)) continue;
        if (found && key.rank == Rank::other && best.rank == Rank::other) unordered = true;
        if (found && !comes_before(key, best)) continue;
        found = true;
        best = key;
        lua_pushvalue(state, -2);
        lua_replace(state, 3);
    }
    Machine::of(state).charge(state, steps);
    if (unordered && (!found || best.rank == Rank::other) && steps > 1)
        return luaL_error(state, "keys that are tables or functions have no order");
    if (!found) return lua_pushnil(state), 1;
    lua_settop(state, 3);
    lua_pushvalue(state, 3);
    lua_rawget(state, 1);
    return 2;
}

constexpr NamedFunction order_functions[] = {{"pairs", pairs}, {"next", next}, {nullptr, nullptr}};

} // namespace

void open_order(lua_State* state) { set_functions(state, order_functions); }

} // namespace hachure::script
