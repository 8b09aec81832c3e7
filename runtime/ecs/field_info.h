#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace hachure {

/// What a field holds, as a user sees it.
enum class FieldKind {
    boolean,
    integer, ///< 32 or 64 bits, signed or not
    real,    ///< float or double
    vec2,
    vec3,
    vec4,
    quaternion, ///< a rotation, of length 1
    color,      ///< vec3 or vec4 (with alpha), linear light
    text,
    enumeration, ///< one of FieldInfo::options
    entity,      ///< a handle; null, and one that is dead by now, are values too
};

/// The kind as it is spelled above.
std::string_view to_string(FieldKind kind);

/// The value of any field. Boolean: bool. Integer: int64 or, for unsigned fields, uint64. Real: double. Vectors and
/// colours: the vector of their size. Text and enumeration (the name of the option): string. Entity: Entity.
using FieldValue = std::variant<bool, std::int64_t, std::uint64_t, double, glm::vec2, glm::vec3, glm::vec4, glm::quat,
                                std::string, Entity>;

/// Inclusive; either end may be infinite.
struct FieldRange {
    double min;
    double max;
};

/// One field of a component: what it is for, what it may be, and access to it by value.
struct FieldInfo {
    std::string name; ///< lower case with underscores
    std::string path; ///< "component.field"
    std::string doc;  ///< one line
    std::string unit; ///< "m", "rad", "s", "px"; empty for a plain number
    FieldKind kind = FieldKind::boolean;
    int bits = 0;                     ///< of an integer or real: 32 or 64; otherwise 0
    std::optional<FieldRange> range;  ///< of an integer, a real, or each element of a vector
    std::vector<std::string> options; ///< of an enumeration, in the order of its enumerators from 0
    FieldValue default_value;         ///< in a default-constructed component
    std::size_t offset = 0;           ///< of the member in the component, in bytes: for what moves many values at once
    std::size_t size = 0;             ///< of the member, in bytes

    /// The field's value in `component`, which is of the type that this field belongs to.
    FieldValue get(const void* component) const;

    /// Writes the field. Throws Error(path, fault) and writes nothing when `value` has a fault.
    void set(void* component, const FieldValue& value) const;

    /// What is wrong with `value` for this field, in words that follow the field's name; empty when it is fine. Wrong
    /// are: another alternative than default_value has, numbers that are not finite, outside the range or too large
    /// for the field, a quaternion that is not of length 1 (to 1e-3), an option that does not exist, and a handle that
    /// no world gives out.
    std::string fault(const FieldValue& value) const;

    // Raw access, an enumeration as the int64 of its enumerator. Set by TypeBuilder; use get and set.
    std::function<FieldValue(const void*)> read;
    std::function<void(void*, const FieldValue&)> write;
};

/// Some fields of one type with their values. They point into its TypeInfo.
using FieldValues = std::vector<std::pair<const FieldInfo*, FieldValue>>;

namespace detail {

template <class M> inline constexpr bool is_vector = false;
template <> inline constexpr bool is_vector<glm::vec2> = true;
template <> inline constexpr bool is_vector<glm::vec3> = true;
template <> inline constexpr bool is_vector<glm::vec4> = true;

template <class M> constexpr FieldKind field_kind() {
    if constexpr (std::is_same_v<M, bool>)
        return FieldKind::boolean;
    else if constexpr (std::is_enum_v<M>)
        return FieldKind::enumeration;
    else if constexpr (std::is_integral_v<M>)
        return FieldKind::integer;
    else if constexpr (std::is_floating_point_v<M>)
        return FieldKind::real;
    else if constexpr (std::is_same_v<M, glm::vec2>)
        return FieldKind::vec2;
    else if constexpr (std::is_same_v<M, glm::vec3>)
        return FieldKind::vec3;
    else if constexpr (std::is_same_v<M, glm::vec4>)
        return FieldKind::vec4;
    else if constexpr (std::is_same_v<M, glm::quat>)
        return FieldKind::quaternion;
    else if constexpr (std::is_same_v<M, Entity>)
        return FieldKind::entity;
    else {
        static_assert(std::is_same_v<M, std::string>, "no field may have this type");
        return FieldKind::text;
    }
}

/// The alternative of FieldValue that carries an M.
template <class M> struct Carrier { using type = M; };
template <class M>
requires(std::is_enum_v<M> ||
         (std::is_integral_v<M> && !std::is_same_v<M, bool> && std::is_signed_v<M>)) struct Carrier<M> {
    using type = std::int64_t;
};
template <class M>
requires(std::is_integral_v<M> && !std::is_same_v<M, bool> && std::is_unsigned_v<M>) struct Carrier<M> {
    using type = std::uint64_t;
};
template <class M>
requires std::is_floating_point_v<M>
struct Carrier<M> {
    using type = double;
};

template <class M> constexpr int field_bits() {
    if constexpr (field_kind<M>() == FieldKind::integer || field_kind<M>() == FieldKind::real) {
        static_assert(sizeof(M) == 4 || sizeof(M) == 8, "numbers have 32 or 64 bits");
        return static_cast<int>(8 * sizeof(M));
    }
    return 0;
}

} // namespace detail
} // namespace hachure
