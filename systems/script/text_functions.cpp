// string.find, match, gmatch and gsub; as lstrlib.c of Lua 5.4 has them (see text_pattern.h), with steps counted.

#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_machine.h>
#include <hachure/systems/script/text_pattern.h>

#include <lua5.4/lua.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace hachure::script {
namespace {

/// Where to begin, from 0, as the argument at `index` says: from 1, or negative from the end.
std::size_t check_start(lua_State* state, int index, std::size_t size) {
    const lua_Integer start = luaL_optinteger(state, index, 1);
    if (start > 0) return static_cast<std::size_t>(start) - 1;
    if (start == 0 || start < -static_cast<lua_Integer>(size)) return 0;
    return size - static_cast<std::size_t>(-start);
}

int push_range(lua_State* state, std::size_t begin, std::size_t end) {
    lua_pushinteger(state, static_cast<lua_Integer>(begin) + 1);
    lua_pushinteger(state, static_cast<lua_Integer>(end));
    return 2;
}

int find_plain(lua_State* state, std::string_view text, std::string_view what, std::size_t start) {
    Machine::of(state).charge(state, static_cast<std::int64_t>((text.size() - start + what.size()) / 16));
    if (what.empty()) return push_range(state, start, start);
    // Linear in both, whatever they are, which std::search is not.
    const void* const at = memmem(text.data() + start, text.size() - start, what.data(), what.size());
    if (!at) return lua_pushnil(state), 1;
    const auto found = static_cast<std::size_t>(static_cast<const char*>(at) - text.data());
    return push_range(state, found, found + what.size());
}

int find_or_match(lua_State* state, bool find) {
    const std::string_view text = check_text(state, 1);
    std::string_view pattern = check_text(state, 2);
    const std::size_t start = check_start(state, 3, text.size());
    if (start > text.size()) return lua_pushnil(state), 1;
    if (find && (lua_toboolean(state, 4) || pattern.find_first_of("^$*+?.([%-") == pattern.npos))
        return find_plain(state, text, pattern, start);
    const bool anchored = pattern.starts_with('^');
    if (anchored) pattern.remove_prefix(1);
    TextPattern matcher(state, text.data(), text.size(), pattern.data(), pattern.size());
    for (const char* at = text.data() + start; at <= text.data() + text.size(); ++at) {
        if (const char* const end = matcher.match(at)) {
            matcher.settle();
            if (!find) return matcher.push_captures(at, end);
            push_range(state, static_cast<std::size_t>(at - text.data()), static_cast<std::size_t>(end - text.data()));
            return 2 + matcher.push_captures(nullptr, nullptr);
        }
        if (anchored) break;
    }
    matcher.settle();
    lua_pushnil(state);
    return 1;
}

int find_pattern(lua_State* state) { return find_or_match(state, true); }
int match(lua_State* state) { return find_or_match(state, false); }

/// Upvalues: text, pattern, where to go on, where the last match ended (-1 for none).
int next_match(lua_State* state) {
    const std::string_view text = check_text(state, lua_upvalueindex(1));
    const std::string_view pattern = check_text(state, lua_upvalueindex(2));
    const char* at = text.data() + lua_tointeger(state, lua_upvalueindex(3));
    const lua_Integer last = lua_tointeger(state, lua_upvalueindex(4));
    TextPattern matcher(state, text.data(), text.size(), pattern.data(), pattern.size());
    for (; at <= text.data() + text.size(); ++at) {
        const char* const end = matcher.match(at);
        if (!end || end - text.data() == last) continue;
        matcher.settle();
        lua_pushinteger(state, end - text.data());
        lua_pushvalue(state, -1);
        lua_replace(state, lua_upvalueindex(3));
        lua_replace(state, lua_upvalueindex(4));
        return matcher.push_captures(at, end);
    }
    matcher.settle();
    lua_pushinteger(state, static_cast<lua_Integer>(text.size()) + 1);
    lua_replace(state, lua_upvalueindex(3));
    return 0;
}

int gmatch(lua_State* state) {
    const std::string_view text = check_text(state, 1);
    luaL_checkstring(state, 2);
    const std::size_t start = std::min(check_start(state, 3, text.size()), text.size() + 1);
    lua_settop(state, 2);
    lua_pushinteger(state, static_cast<lua_Integer>(start));
    lua_pushinteger(state, -1);
    lua_pushcclosure(state, next_match, 4);
    return 1;
}

/// Adds the replacement text at 3 with "%1" and the like filled in.
void add_text(lua_State* state, TextPattern& matcher, luaL_Buffer& result, const char* begin, const char* end) {
    const std::string_view replacement = check_text(state, 3);
    for (std::size_t i = 0; i < replacement.size(); ++i) {
        if (replacement[i] != '%') {
            luaL_addchar(&result, replacement[i]);
            continue;
        }
        const char letter = ++i < replacement.size() ? replacement[i] : '\0';
        if (letter == '%') {
            luaL_addchar(&result, '%');
        } else if (letter == '0') {
            luaL_addlstring(&result, begin, static_cast<std::size_t>(end - begin));
        } else if (letter >= '1' && letter <= '9') {
            matcher.push_capture(letter - '1', begin, end);
            luaL_tolstring(state, -1, nullptr); // a position is a number
            lua_remove(state, -2);
            luaL_addvalue(&result);
        } else {
            luaL_error(state, "invalid use of '%%' in replacement string");
        }
    }
}

/// Adds what stands for a match: the text, the table's value or the function's result; the match itself for false and
/// nil. Whether it is something else than the match.
bool add_value(lua_State* state, TextPattern& matcher, luaL_Buffer& result, const char* begin, const char* end) {
    switch (lua_type(state, 3)) {
    case LUA_TFUNCTION: {
        lua_pushvalue(state, 3);
        const int count = matcher.push_captures(begin, end);
        lua_call(state, count, 1);
        break;
    }
    case LUA_TTABLE:
        matcher.push_capture(0, begin, end);
        lua_gettable(state, 3);
        break;
    default:
        add_text(state, matcher, result, begin, end);
        return true;
    }
    if (!lua_toboolean(state, -1)) {
        lua_pop(state, 1);
        luaL_addlstring(&result, begin, static_cast<std::size_t>(end - begin));
        return false;
    }
    if (!lua_isstring(state, -1)) luaL_error(state, "invalid replacement value (a %s)", luaL_typename(state, -1));
    luaL_addvalue(&result);
    return true;
}

int gsub(lua_State* state) {
    const std::string_view text = check_text(state, 1);
    std::string_view pattern = check_text(state, 2);
    const int type = lua_type(state, 3);
    luaL_argexpected(state, type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE,
                     3, "string/function/table");
    const lua_Integer most = luaL_optinteger(state, 4, static_cast<lua_Integer>(text.size()) + 1);
    const bool anchored = pattern.starts_with('^');
    if (anchored) pattern.remove_prefix(1);
    const char* at = text.data();
    const char* const text_end = at + text.size();
    const char* last = nullptr;
    lua_Integer count = 0;
    TextPattern matcher(state, text.data(), text.size(), pattern.data(), pattern.size());
    luaL_Buffer result;
    luaL_buffinit(state, &result);
    while (count < most) {
        const char* const end = matcher.match(at);
        if (end && end != last) {
            ++count;
            add_value(state, matcher, result, at, end);
            at = last = end;
        } else if (at < text_end) {
            luaL_addchar(&result, *at++);
        } else {
            break;
        }
        if (anchored) break;
    }
    matcher.settle();
    luaL_addlstring(&result, at, static_cast<std::size_t>(text_end - at));
    luaL_pushresult(&result);
    lua_pushinteger(state, count);
    return 2;
}

constexpr NamedFunction pattern_functions[] = {
    {"find", find_pattern}, {"match", match}, {"gmatch", gmatch}, {"gsub", gsub}, {nullptr, nullptr}};

} // namespace

void open_patterns(lua_State* state) { set_functions(state, pattern_functions); }

} // namespace hachure::script
