#include <hachure/systems/script/lua_vector.h>

#include <lua5.4/lua.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::script {
namespace {

/// The vector at `index`; raises an error when it is none, or of another kind than the one at 1.
const VectorBox& operand(lua_State* state, int index) {
    const VectorBox* const first = vector_at(state, 1);
    const VectorBox* const box = vector_at(state, index);
    if (!box || !first || box->kind != first->kind) luaL_argerror(state, index, "a vector of the same kind is needed");
    return *box;
}

glm::vec3 vec3_of(lua_State* state, int index) {
    const VectorBox* const box = vector_at(state, index);
    if (!box || box->kind != BoxKind::vec3) luaL_argerror(state, index, "a vec3 is needed");
    return {box->at[0], box->at[1], box->at[2]};
}

glm::quat quat_of(lua_State* state, int index) {
    const VectorBox* const box = vector_at(state, index);
    if (!box || box->kind != BoxKind::quat) luaL_argerror(state, index, "a quat is needed");
    return {box->at[3], box->at[0], box->at[1], box->at[2]};
}

int push(lua_State* state, const glm::quat& q) {
    const float at[] = {q.x, q.y, q.z, q.w};
    push_vector(state, BoxKind::quat, at);
    return 1;
}

int push(lua_State* state, const glm::vec3& v) {
    push_vector(state, BoxKind::vec3, &v.x);
    return 1;
}

float sum_of_products(const VectorBox& a, const VectorBox& b) {
    return a.at[0] * b.at[0] + a.at[1] * b.at[1] + a.at[2] * b.at[2] + a.at[3] * b.at[3];
}

int dot(lua_State* state) {
    lua_pushnumber(state, sum_of_products(operand(state, 1), operand(state, 2)));
    return 1;
}

int length(lua_State* state) {
    const VectorBox& a = operand(state, 1);
    lua_pushnumber(state, std::sqrt(sum_of_products(a, a)));
    return 1;
}

/// A vector without a direction stays as it is, so that no NaN comes into the world.
int normalize(lua_State* state) {
    const VectorBox& a = operand(state, 1);
    const float size = std::sqrt(sum_of_products(a, a));
    const float factor = size > 0.0f && std::isfinite(size) ? 1.0f / size : 1.0f;
    float result[4];
    std::transform(a.at, a.at + 4, result, [factor](float x) { return x * factor; });
    push_vector(state, a.kind, result);
    return 1;
}

int lerp(lua_State* state) {
    const VectorBox& a = operand(state, 1);
    const VectorBox& b = operand(state, 2);
    const auto t = static_cast<float>(luaL_checknumber(state, 3));
    float result[4];
    for (int i = 0; i < 4; ++i) result[i] = a.at[i] + t * (b.at[i] - a.at[i]);
    push_vector(state, a.kind, result);
    return 1;
}

int cross(lua_State* state) { return push(state, glm::cross(vec3_of(state, 1), vec3_of(state, 2))); }
int rotate(lua_State* state) { return push(state, quat_of(state, 1) * vec3_of(state, 2)); }
int inverse(lua_State* state) { return push(state, glm::conjugate(quat_of(state, 1))); }

int slerp(lua_State* state) {
    const auto t = static_cast<float>(luaL_checknumber(state, 3));
    return push(state, glm::normalize(glm::slerp(quat_of(state, 1), quat_of(state, 2), t)));
}

constexpr NamedFunction for_all[] = {{"dot", dot}, {"length", length}, {"normalize", normalize}, {nullptr, nullptr}};
constexpr NamedFunction for_vectors[] = {{"lerp", lerp}, {nullptr, nullptr}};
constexpr NamedFunction for_vec3[] = {{"cross", cross}, {nullptr, nullptr}};
constexpr NamedFunction for_quat[] = {{"rotate", rotate}, {"slerp", slerp}, {"inverse", inverse}, {nullptr, nullptr}};

} // namespace

void set_vector_methods(lua_State* state, BoxKind kind) {
    set_functions(state, for_all);
    set_functions(state, kind == BoxKind::quat ? for_quat : for_vectors);
    if (kind == BoxKind::vec3) set_functions(state, for_vec3);
}

} // namespace hachure::script
