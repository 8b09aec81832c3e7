// Arithmetic of vectors and rotations. lua_vector_methods.cpp has what is called by name.

#include <hachure/systems/script/lua_vector.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hachure::script {
namespace {

constexpr const char* kind_names[] = {"vec2", "vec3", "vec4", "quat"};

const char* name_of(BoxKind kind) { return kind_names[static_cast<int>(kind)]; }

glm::quat quat_of(const VectorBox& box) { return {box.at[3], box.at[0], box.at[1], box.at[2]}; }

void push_quat(lua_State* state, const glm::quat& q) {
    const float at[] = {q.x, q.y, q.z, q.w};
    push_vector(state, BoxKind::quat, at);
}

int wrong_operands(lua_State* state, const char* what) {
    return luaL_error(state, "no way to %s %s and %s", what, luaL_tolstring(state, 1, nullptr),
                      luaL_tolstring(state, 2, nullptr));
}

/// Applies `operation` to two vectors of a kind, element by element; a number stands for as many of itself where
/// `numbers` are allowed.
template <class F> int combine(lua_State* state, const char* what, bool numbers, F operation) {
    const VectorBox* const a = vector_at(state, 1);
    const VectorBox* const b = vector_at(state, 2);
    const BoxKind kind = a ? a->kind : b->kind;
    if (a && b && a->kind != b->kind) return wrong_operands(state, what);
    if ((!a || !b) && (!numbers || lua_type(state, a ? 2 : 1) != LUA_TNUMBER)) return wrong_operands(state, what);
    const auto number = static_cast<float>(a && b ? 0.0 : lua_tonumber(state, a ? 2 : 1));
    float result[4] = {};
    for (int i = 0; i < size_of(kind); ++i) result[i] = operation(a ? a->at[i] : number, b ? b->at[i] : number);
    push_vector(state, kind, result);
    return 1;
}

int add(lua_State* state) {
    return combine(state, "add", false, [](float a, float b) { return a + b; });
}

int subtract(lua_State* state) {
    return combine(state, "subtract", false, [](float a, float b) { return a - b; });
}

int divide(lua_State* state) {
    return combine(state, "divide", true, [](float a, float b) { return a / b; });
}

/// Rotations are composed, and turn vec3; everything else goes element by element.
int multiply(lua_State* state) {
    const VectorBox* const a = vector_at(state, 1);
    const VectorBox* const b = vector_at(state, 2);
    if (a && b && a->kind == BoxKind::quat && b->kind == BoxKind::quat) {
        push_quat(state, quat_of(*a) * quat_of(*b));
        return 1;
    }
    if (a && b && a->kind == BoxKind::quat && b->kind == BoxKind::vec3) {
        const glm::vec3 turned = quat_of(*a) * glm::vec3(b->at[0], b->at[1], b->at[2]);
        push_vector(state, BoxKind::vec3, &turned.x);
        return 1;
    }
    return combine(state, "multiply", true, [](float a_i, float b_i) { return a_i * b_i; });
}

int negate(lua_State* state) {
    const VectorBox* const a = vector_at(state, 1);
    float result[4] = {};
    std::transform(a->at, a->at + 4, result, [](float x) { return -x; });
    push_vector(state, a->kind, result);
    return 1;
}

int equal_vectors(lua_State* state) {
    const VectorBox* const a = vector_at(state, 1);
    const VectorBox* const b = vector_at(state, 2);
    lua_pushboolean(state, a && b && a->kind == b->kind && std::equal(a->at, a->at + 4, b->at));
    return 1;
}

int vector_text(lua_State* state) {
    const VectorBox* const a = vector_at(state, 1);
    if (!a) return luaL_argerror(state, 1, "no vector");
    luaL_Buffer text;
    luaL_buffinit(state, &text);
    luaL_addstring(&text, name_of(a->kind));
    for (int i = 0; i < size_of(a->kind); ++i) {
        luaL_addstring(&text, i == 0 ? "(" : ", ");
        char number[32];
        lua_Number value = a->at[i];
        snprintf(number, sizeof number, "%.7g", value);
        luaL_addstring(&text, number);
    }
    luaL_addchar(&text, ')');
    luaL_pushresult(&text);
    return 1;
}

/// An element by its letter (x y z w, and r g b a for colours), or a method, which upvalue 1 has.
int element(lua_State* state) {
    const VectorBox* const a = vector_at(state, 1);
    if (lua_type(state, 2) != LUA_TSTRING) return luaL_error(state, "%s has no such element", name_of(a->kind));
    std::size_t length = 0;
    const char* const key = lua_tolstring(state, 2, &length);
    if (length == 1) {
        static constexpr char letters[] = "xyzwrgba";
        const auto* const found = std::find(letters, letters + 8, key[0]);
        const auto at = static_cast<int>((found - letters) % 4);
        if (found != letters + 8 && at < size_of(a->kind) && (found < letters + 4 || a->kind != BoxKind::quat)) {
            lua_pushnumber(state, a->at[at]);
            return 1;
        }
    }
    lua_pushvalue(state, 2);
    if (lua_rawget(state, lua_upvalueindex(1)) != LUA_TNIL) return 1;
    return luaL_error(state, "%s has no element %s", name_of(a->kind), key);
}

int no_vector_assignment(lua_State* state) {
    return luaL_error(state, "a vector is a value: assign a new one, as in e.transform.scale = vec3(1, 2, 1)");
}

constexpr NamedFunction operators[] = {
    {"__add", add},    {"__sub", subtract},     {"__mul", multiply},         {"__div", divide},
    {"__unm", negate}, {"__eq", equal_vectors}, {"__tostring", vector_text}, {"__newindex", no_vector_assignment},
    {nullptr, nullptr}};

/// vec3(): zeros; vec3(1): three of it; vec3(1, 2, 3). Upvalue 1 is the kind. quat() is no turn. Numbers are x, y, z,
/// w. A quat from numbers is made to have length 1. Argument 1 is the table that is called.
int construct(lua_State* state) {
    const auto kind = static_cast<BoxKind>(lua_tointeger(state, lua_upvalueindex(1)));
    const int count = lua_gettop(state) - 1, size = size_of(kind);
    float at[4] = {};
    if (kind == BoxKind::quat && count == 0) at[3] = 1.0f;
    const bool same = count == 1 && kind != BoxKind::quat;
    if (count != 0 && count != size && !same) return luaL_error(state, "%s takes %d numbers", name_of(kind), size);
    for (int i = 0; i < size && count > 0; ++i) at[i] = static_cast<float>(luaL_checknumber(state, same ? 2 : i + 2));
    if (kind == BoxKind::quat) {
        const float length = glm::length(glm::quat(at[3], at[0], at[1], at[2]));
        if (!(length > 1e-12f) || !std::isfinite(length)) return luaL_error(state, "no rotation has length 0");
        for (float& x : at) x /= length;
    }
    push_vector(state, kind, at);
    return 1;
}

/// quat.axis_angle(axis, angle): a turn about `axis`, which needs no length 1, by `angle` radians.
int axis_angle(lua_State* state) {
    const VectorBox* const axis = vector_at(state, 1);
    if (!axis || axis->kind != BoxKind::vec3) return luaL_argerror(state, 1, "the axis is a vec3");
    const auto angle = static_cast<float>(luaL_checknumber(state, 2));
    const glm::vec3 direction(axis->at[0], axis->at[1], axis->at[2]);
    const float length = glm::length(direction);
    if (!(length > 1e-12f) || !std::isfinite(length)) return luaL_argerror(state, 1, "the axis has no direction");
    push_quat(state, glm::angleAxis(angle, direction / length));
    return 1;
}

} // namespace

const VectorBox* vector_at(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TUSERDATA) return nullptr;
    const auto* const box = static_cast<const VectorBox*>(lua_touserdata(state, index));
    return box->kind <= BoxKind::quat ? box : nullptr;
}

void push_vector(lua_State* state, BoxKind kind, const float* at) {
    auto* const box = static_cast<VectorBox*>(lua_newuserdatauv(state, sizeof(VectorBox), 0));
    *box = {kind, {}};
    std::copy_n(at, size_of(kind), box->at);
    lua_rawgeti(state, LUA_REGISTRYINDEX, context_of(state).vector_methods[static_cast<int>(kind)]);
    lua_setmetatable(state, -2);
}

void open_vectors(lua_State* state) {
    for (int i = 0; i < 4; ++i) {
        const auto kind = static_cast<BoxKind>(i);
        push_metatable(state, name_of(kind), operators);
        lua_newtable(state);
        set_vector_methods(state, kind);
        lua_pushcclosure(state, element, 1);
        lua_setfield(state, -2, "__index");
        context_of(state).vector_methods[i] = luaL_ref(state, LUA_REGISTRYINDEX);

        lua_newtable(state); // other ways of making one
        if (kind == BoxKind::quat) {
            lua_pushcfunction(state, axis_angle);
            lua_setfield(state, -2, "axis_angle");
        }
        protect_table(state, name_of(kind));
        lua_getmetatable(state, -1);
        lua_pushinteger(state, i);
        lua_pushcclosure(state, construct, 1);
        lua_setfield(state, -2, "__call");
        lua_pop(state, 1);
        lua_setfield(state, -2, name_of(kind));
    }
}

} // namespace hachure::script
