// What people do, what time it is, and lines for the log.

#include <hachure/runtime/app/input.h>
#include <hachure/runtime/app/log.h>
#include <hachure/systems/script/lua_vector.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

#include <string>
#include <string_view>

namespace hachure::script {
namespace {

constexpr std::int64_t steps_of_logging = 1000;

const Input& input_of(lua_State* state) {
    static const Input nothing;
    const Input* const input = context_of(state).world->find_resource<Input>();
    return input ? *input : nothing;
}

std::string_view check_key(lua_State* state) {
    std::size_t length = 0;
    const char* const text = luaL_checklstring(state, 1, &length);
    return {text, length};
}

int down(lua_State* state) {
    lua_pushboolean(state, input_of(state).is_down(check_key(state)));
    return 1;
}

int pressed(lua_State* state) {
    lua_pushboolean(state, input_of(state).was_pressed(check_key(state)));
    return 1;
}

int released(lua_State* state) {
    lua_pushboolean(state, input_of(state).was_released(check_key(state)));
    return 1;
}

int button(lua_State* state) {
    lua_pushboolean(state, input_of(state).buttons.contains(check_key(state)));
    return 1;
}

/// What of `input` changes from frame to frame; upvalue 1 has the functions.
int get_input(lua_State* state) {
    lua_pushvalue(state, 2);
    if (lua_rawget(state, lua_upvalueindex(1)) != LUA_TNIL) return 1;
    const std::string_view key = lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : "";
    const Input& input = input_of(state);
    if (key == "pointer") return push_vector(state, BoxKind::vec2, &input.pointer.x), 1;
    if (key == "pointer_delta") return push_vector(state, BoxKind::vec2, &input.pointer_delta.x), 1;
    if (key == "scroll") return push_vector(state, BoxKind::vec2, &input.scroll.x), 1;
    return luaL_error(state, "there is no input.%s", push_text(state, 2));
}

int get_time(lua_State* state) {
    const std::string_view key = lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : "";
    const Context& context = context_of(state);
    if (key == "seconds") return lua_pushnumber(state, context.seconds), 1;
    if (key == "frame") return lua_pushinteger(state, static_cast<lua_Integer>(context.frame)), 1;
    return luaL_error(state, "there is no time.%s", push_text(state, 2));
}

int no_frame_assignment(lua_State* state) { return luaL_error(state, "this can't be assigned"); }

/// Puts an empty table with the function on top of the stack as its __index into the table below, as `name`.
void set_view(lua_State* state, const char* name) {
    lua_newtable(state);
    push_metatable(
        state, name,
        std::initializer_list<NamedFunction>{{"__newindex", no_frame_assignment}, {nullptr, nullptr}}.begin());
    lua_pushvalue(state, -3);
    lua_setfield(state, -2, "__index");
    lua_setmetatable(state, -2);
    lua_remove(state, -2);
    lua_setfield(state, -2, name);
}

void log_line(const std::string& chunk, std::string_view text) { log_note(chunk + ": " + std::string(text)); }

int log(lua_State* state) {
    const int count = lua_gettop(state);
    context_of(state).machine->charge(state, steps_of_logging);
    luaL_checkstack(state, count + 2, "too many values");
    lua_pushliteral(state, "");
    for (int i = 1; i <= count; ++i) {
        if (i > 1) lua_pushliteral(state, " ");
        push_text(state, i);
        lua_concat(state, i > 1 ? 3 : 2);
    }
    std::size_t length = 0;
    const char* const text = lua_tolstring(state, -1, &length);
    log_line(context_of(state).machine->chunk(), {text, length});
    return 0;
}

constexpr NamedFunction frame_functions[] = {{"down", bound<down>},
                                             {"pressed", bound<pressed>},
                                             {"released", bound<released>},
                                             {"button", bound<button>},
                                             {nullptr, nullptr}};

} // namespace

void open_frame(lua_State* state) {
    lua_newtable(state);
    set_functions(state, frame_functions);
    lua_pushcclosure(state, get_input, 1);
    set_view(state, "input");
    lua_pushcfunction(state, get_time);
    set_view(state, "time");
    lua_pushcfunction(state, bound<log>);
    lua_pushvalue(state, -1);
    lua_setfield(state, -3, "print");
    lua_setfield(state, -2, "log");
}

} // namespace hachure::script
