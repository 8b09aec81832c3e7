// pcall, xpcall and coroutines that let no stop go by.

#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_machine.h>
#include <hachure/systems/script/sandbox.h>
#include <hachure/systems/script/script_api.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {
namespace {

constexpr std::int64_t steps_of_resuming = 20;

/// What follows the call of pcall and xpcall; `below` values of the stack are no results.
int finish_call(lua_State* state, int status, lua_KContext below) {
    Machine& machine = Machine::of(state);
    machine.set_running(state);
    machine.raise_if_stopped(state);
    if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(state) - static_cast<int>(below);
    lua_pushboolean(state, 0);
    lua_pushvalue(state, -2);
    return 2;
}

int protected_call(lua_State* state) {
    luaL_checkany(state, 1);
    lua_pushboolean(state, 1);
    lua_insert(state, 1);
    const int status = lua_pcallk(state, lua_gettop(state) - 2, LUA_MULTRET, 0, 0, finish_call);
    return finish_call(state, status, 0);
}

/// The script's handler, unless what it would handle is a stop.
int handle(lua_State* state) {
    if (Machine::of(state).stopped()) return 1;
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, 1);
    return 1;
}

int protected_call_with_handler(lua_State* state) {
    const int arguments = lua_gettop(state) - 2;
    luaL_checktype(state, 2, LUA_TFUNCTION);
    lua_pushvalue(state, 2);
    lua_pushcclosure(state, handle, 1);
    lua_replace(state, 2);
    lua_pushboolean(state, 1); // first result
    lua_pushvalue(state, 1);   // the function
    lua_rotate(state, 3, 2);   // both below the arguments
    const int status = lua_pcallk(state, arguments, LUA_MULTRET, 2, 2, finish_call);
    return finish_call(state, status, 2);
}

/// Calls the function of the library in upvalue 1, which runs coroutine `inner`.
int run_coroutine(lua_State* state, lua_State* inner) {
    Machine& machine = Machine::of(state);
    machine.charge(state, steps_of_resuming);
    machine.set_running(inner ? inner : state);
    const int results = lua_tocfunction(state, lua_upvalueindex(1))(state);
    machine.set_running(state);
    machine.raise_if_stopped(state);
    return results;
}

int resume_or_close(lua_State* state) { return run_coroutine(state, lua_tothread(state, 1)); }

/// Calls what coroutine.wrap made (upvalue 1) for the coroutine (upvalue 2).
int call_wrapped(lua_State* state) {
    Machine& machine = Machine::of(state);
    machine.charge(state, steps_of_resuming);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    machine.set_running(lua_tothread(state, lua_upvalueindex(2)));
    lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
    machine.set_running(state);
    machine.raise_if_stopped(state);
    return lua_gettop(state);
}

/// A new coroutine counts its instructions from 0, so that many short ones would never be counted.
int create(lua_State* state) {
    Machine::of(state).charge(state, Machine::hook_interval);
    return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

int wrap(lua_State* state) {
    create(state);
    lua_getupvalue(state, -1, 1); // the coroutine
    lua_pushcclosure(state, call_wrapped, 2);
    return 1;
}

} // namespace

void open_calls(lua_State* state) {
    lua_pushcfunction(state, protected_call);
    lua_setfield(state, -2, "pcall");
    lua_pushcfunction(state, protected_call_with_handler);
    lua_setfield(state, -2, "xpcall");
    luaL_requiref(state, "coroutine", luaopen_coroutine, 0);
    enclose(state, "resume", resume_or_close);
    enclose(state, "close", resume_or_close);
    enclose(state, "create", create);
    enclose(state, "wrap", wrap);
    protect_table(state, "coroutine");
    lua_setfield(state, -2, "coroutine");
}

} // namespace hachure::script
