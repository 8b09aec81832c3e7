#pragma once

struct lua_State;

/// What of Lua scripts get: nothing that reaches files, the system, other scripts or the insides of Lua; nothing that
/// catches a stop, works without being counted, or depends on addresses and hash seeds.
namespace hachure::script {

/// Makes the table of globals, for a new state, as the reference Context::globals.
void open_sandbox(lua_State* state);

// Parts of it, each into the table on top of the stack.
void open_calls(lua_State* state);  ///< pcall, xpcall, coroutine
void open_texts(lua_State* state);  ///< tostring, tonumber, string, utf8
void open_tables(lua_State* state); ///< setmetatable, rawset, collectgarbage, table
void open_order(lua_State* state);  ///< pairs, next

/// What a function of the standard library costs, which `push_counted` lets it pay for.
enum class Cost {
    texts,  ///< the length of its texts
    insert, ///< of elements of a list, those that it moves
    remove,
    concat,
    unpack,
    move,
    sort,
};

/// Pushes the function of C on top of the stack as one that is counted, in its place.
void push_counted(lua_State* state, Cost cost);

} // namespace hachure::script
