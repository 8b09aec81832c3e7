#pragma once

#include <hachure/systems/script/lua_binding.h>

#include <glm/gtc/quaternion.hpp>

struct lua_State;

namespace hachure::script {

/// A value vec2, vec3, vec4 or quat of scripts. It can't change.
struct VectorBox {
    BoxKind kind; ///< one of the first four
    float at[4];  ///< x, y, z, w; those beyond its size are 0
};

/// The vector at `index`, or null.
[[nodiscard]] const VectorBox* vector_at(lua_State* state, int index);

[[nodiscard]] inline int size_of(BoxKind kind) { return kind == BoxKind::vec2 ? 2 : kind == BoxKind::vec3 ? 3 : 4; }

/// Pushes a vector; `at` has as many numbers as the kind.
void push_vector(lua_State* state, BoxKind kind, const float* at);

/// Makes the types known, with the globals vec2, vec3, vec4 and quat in the table on top of the stack.
void open_vectors(lua_State* state);

/// The methods of vectors: `v:dot(w)` and so on, by name in the table on top of the stack.
void set_vector_methods(lua_State* state, BoxKind kind);

} // namespace hachure::script
