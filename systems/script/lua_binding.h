#pragma once

#include <exception>
#include <string_view>

struct lua_State;

/// Functions of C++ that Lua calls. Lua's errors are long jumps, which skip the ends of C++ objects, and exceptions
/// must not pass through Lua. So a function that calls Lua holds no object that needs its end, and what throws is
/// `bound`.
namespace hachure::script {

/// Remembers what is to be raised. Never throws.
void keep_fault(lua_State* state, const char* message) noexcept;

/// Raises what was kept, with the place in the script. Does not return.
int raise_fault(lua_State* state);

/// `F` as a function for Lua, with exceptions turned into errors of the script.
template <int (*F)(lua_State*)> int bound(lua_State* state) {
    try {
        return F(state);
    } catch (const std::exception& exception) {
        keep_fault(state, exception.what());
    }
    return raise_fault(state);
}

/// What every full userdata of a script begins with.
enum class BoxKind : unsigned { vec2, vec3, vec4, quat, entity, component, query };

/// The userdata at `index` of this kind, or null.
void* box_at(lua_State* state, int index, BoxKind kind);

/// The text at `index`, which Lua owns; raises an error when there is none.
[[nodiscard]] std::string_view check_text(lua_State* state, int index);

struct NamedFunction {
    const char* name;
    int (*function)(lua_State*);
};

/// Puts `functions` into the table on top of the stack; the list ends with a null name.
void set_functions(lua_State* state, const NamedFunction* functions);

/// Replaces the function `name` of the table on top of the stack by `around`, which has it as upvalue 1.
void enclose(lua_State* state, const char* name, int (*around)(lua_State*));

/// Makes a metatable on top of the stack that scripts can't see: `functions`, and a name for messages.
void push_metatable(lua_State* state, const char* name, const NamedFunction* functions);

} // namespace hachure::script
