#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/lua_fields.h>
#include <hachure/systems/script/lua_vector.h>

#include <fmt/format.h>
#include <lua5.4/lua.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

namespace hachure::script {
namespace {

template <class T> T load(const void* component, const FieldInfo& field) {
    T value;
    std::memcpy(&value, static_cast<const std::byte*>(component) + field.offset, sizeof value);
    return value;
}

void push_integer(lua_State* state, const FieldInfo& field, const void* component) {
    const bool is_signed = std::holds_alternative<std::int64_t>(field.default_value);
    if (field.bits == 64) return lua_pushinteger(state, load<std::int64_t>(component, field)); // wraps as Lua's do
    const lua_Integer value = is_signed ? lua_Integer{load<std::int32_t>(component, field)}
                                        : lua_Integer{load<std::uint32_t>(component, field)};
    lua_pushinteger(state, value);
}

void push_option(lua_State* state, const FieldKey& field, const void* component) {
    std::uint64_t option = 0; // little-endian, as everything that the house runs on
    std::memcpy(&option, static_cast<const std::byte*>(component) + field.info->offset, field.info->size);
    HACHURE_ASSERT(option < field.options.size(), "an enumeration holds one of its options");
    lua_rawgeti(state, LUA_REGISTRYINDEX, field.options[option]);
}

/// The numbers of a short table; leaves `given` alone when it is no such table.
void take_numbers(lua_State* state, int index, Given& given) {
    const auto size = static_cast<int>(std::min<lua_Unsigned>(lua_rawlen(state, index), 5));
    if (size < 2 || size > 4) return;
    for (int i = 0; i < size; ++i) {
        const bool number = lua_rawgeti(state, index, i + 1) == LUA_TNUMBER;
        given.at[i] = static_cast<float>(lua_tonumber(state, -1));
        lua_pop(state, 1);
        if (!number) return;
    }
    given.kind = Given::Kind::vector;
    given.size = size;
}

void take_userdata(lua_State* state, int index, Given& given) {
    if (const VectorBox* const vector = vector_at(state, index)) {
        given.kind = vector->kind == BoxKind::quat ? Given::Kind::rotation : Given::Kind::vector;
        given.size = size_of(vector->kind);
        std::memcpy(given.at, vector->at, sizeof given.at);
        given.type = given.kind == Given::Kind::rotation ? "quat" : "vector";
    } else if (const EntityBox* const entity = entity_at(state, index)) {
        given.kind = Given::Kind::entity;
        given.entity = entity->entity;
        given.type = "entity";
    }
}

[[noreturn]] void throw_no(const FieldInfo& field, const Given& given) {
    throw Error(field.path, fmt::format("a {} is no {}", given.type, to_string(field.kind)));
}

template <class T> FieldValue integer_for(const FieldInfo& field, const Given& given) {
    if (given.kind == Given::Kind::integer) {
        if (!std::in_range<T>(given.integer)) throw Error(field.path, fmt::format("{} is below 0", given.integer));
        return static_cast<T>(given.integer);
    }
    if (given.kind != Given::Kind::real) throw_no(field, given);
    throw Error(field.path, fmt::format("{} is no whole number", given.real));
}

FieldValue vector_for(const FieldInfo& field, const Given& given) {
    const auto& v = given.at;
    const bool rotation = field.kind == FieldKind::quaternion;
    if (rotation ? given.kind != Given::Kind::rotation && !(given.kind == Given::Kind::vector && given.size == 4)
                 : given.kind != Given::Kind::vector)
        throw_no(field, given);
    if (rotation) return glm::quat(v[3], v[0], v[1], v[2]);
    FieldValue value;
    if (given.size == 2) value = glm::vec2(v[0], v[1]);
    if (given.size == 3) value = glm::vec3(v[0], v[1], v[2]);
    if (given.size == 4) value = glm::vec4(v[0], v[1], v[2], v[3]);
    if (value.index() != field.default_value.index())
        throw Error(field.path, fmt::format("{} numbers are no {}", given.size, to_string(field.kind)));
    return value;
}

FieldValue unchecked_value_for(const FieldInfo& field, const Given& given) {
    using Kind = Given::Kind;
    switch (field.kind) {
    case FieldKind::boolean:
        if (given.kind != Kind::boolean) throw_no(field, given);
        return given.boolean;
    case FieldKind::integer:
        return std::holds_alternative<std::int64_t>(field.default_value) ? integer_for<std::int64_t>(field, given)
                                                                         : integer_for<std::uint64_t>(field, given);
    case FieldKind::real:
        if (given.kind != Kind::real && given.kind != Kind::integer) throw_no(field, given);
        return given.real;
    case FieldKind::text:
    case FieldKind::enumeration:
        if (given.kind != Kind::text) throw_no(field, given);
        return std::string(given.text);
    case FieldKind::entity:
        if (given.kind != Kind::entity && given.kind != Kind::nothing) throw_no(field, given);
        return given.entity;
    default:
        return vector_for(field, given);
    }
}

} // namespace

Given given_at(lua_State* state, int index) {
    Given given;
    given.type = luaL_typename(state, index);
    switch (lua_type(state, index)) {
    case LUA_TNIL:
        break;
    case LUA_TBOOLEAN:
        given.kind = Given::Kind::boolean;
        given.boolean = lua_toboolean(state, index);
        break;
    case LUA_TNUMBER: {
        int whole = 0;
        given.integer = lua_tointegerx(state, index, &whole);
        given.real = lua_tonumber(state, index);
        given.kind = whole ? Given::Kind::integer : Given::Kind::real;
        break;
    }
    case LUA_TSTRING: {
        std::size_t length = 0;
        const char* const text = lua_tolstring(state, index, &length);
        given.text = {text, length};
        given.kind = Given::Kind::text;
        break;
    }
    default:
        given.kind = Given::Kind::other;
        if (lua_type(state, index) == LUA_TTABLE) take_numbers(state, index, given);
        if (lua_type(state, index) == LUA_TUSERDATA) take_userdata(state, index, given);
    }
    return given;
}

FieldValue value_for(const FieldInfo& field, const Given& given) {
    FieldValue value = unchecked_value_for(field, given);
    if (const std::string fault = field.fault(value); !fault.empty()) throw Error(field.path, fault);
    return value;
}

void push_field(lua_State* state, const FieldKey& field, const void* component) {
    const FieldInfo& info = *field.info;
    const auto* const at = static_cast<const std::byte*>(component) + info.offset;
    switch (info.kind) {
    case FieldKind::boolean:
        return lua_pushboolean(state, load<bool>(component, info));
    case FieldKind::integer:
        return push_integer(state, info, component);
    case FieldKind::real:
        return lua_pushnumber(state, info.bits == 32 ? load<float>(component, info) : load<double>(component, info));
    case FieldKind::quaternion: {
        const auto q = load<glm::quat>(component, info);
        const float xyzw[] = {q.x, q.y, q.z, q.w};
        return push_vector(state, BoxKind::quat, xyzw);
    }
    case FieldKind::vec2:
    case FieldKind::vec3:
    case FieldKind::vec4:
    case FieldKind::color: {
        float elements[4] = {};
        std::memcpy(elements, at, info.size);
        return push_vector(state, static_cast<BoxKind>(info.size / sizeof(float) - 2), elements);
    }
    case FieldKind::text: {
        const auto& text = *reinterpret_cast<const std::string*>(at);
        lua_pushlstring(state, text.data(), text.size());
        return;
    }
    case FieldKind::enumeration:
        return push_option(state, field, component);
    case FieldKind::entity:
        return push_entity(state, load<Entity>(component, info));
    }
}

} // namespace hachure::script
