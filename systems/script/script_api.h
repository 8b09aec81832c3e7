#pragma once

struct lua_State;

/// What scripts find among their globals. Each function puts its part into the table on top of the stack.
namespace hachure::script {

void open_scene(lua_State* state);  ///< scene.find, find_all, spawn, send
void open_query(lua_State* state);  ///< scene.query, into the table `scene`
void open_random(lua_State* state); ///< random
void open_frame(lua_State* state);  ///< input, time, log, print

/// Pushes a read-only view of the table on top of the stack in its place.
void protect_table(lua_State* state, const char* name);

/// Pushes what the value at `index` reads as: like luaL_tolstring, without addresses.
const char* push_text(lua_State* state, int index);

} // namespace hachure::script
