#pragma once

#include <hachure/runtime/ecs/field_info.h>
#include <hachure/systems/script/component_keys.h>

#include <string_view>

struct lua_State;

namespace hachure::script {

/// A value of Lua that a field may be given, taken off the stack.
struct Given {
    enum class Kind { nothing, boolean, integer, real, text, vector, rotation, entity, other };

    Kind kind = Kind::nothing;
    bool boolean = false;
    long long integer = 0;
    double real = 0;
    std::string_view text; ///< holds while the value is on the stack
    float at[4] = {};
    int size = 0; ///< of a vector
    Entity entity;
    const char* type = ""; ///< of Lua
};

/// What stands at `index`. Tables of 2 to 4 numbers count as vectors.
[[nodiscard]] Given given_at(lua_State* state, int index);

/// `given` as a value of the field. Throws Error(path, fault) when it is none, or when the field does not allow it.
[[nodiscard]] FieldValue value_for(const FieldInfo& field, const Given& given);

/// Pushes what the field holds in `component`.
void push_field(lua_State* state, const FieldKey& field, const void* component);

} // namespace hachure::script
