#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/assets/json_value.h>
#include <hachure/runtime/ecs/field_info.h>

#include <glm/vec4.hpp>

namespace hachure {

/// The value of a key for a field that is made of numbers, or for one element of it; the others of the result are 0.
/// Colours may be written as "#rrggbb". Throws Error for what the field can't hold.
[[nodiscard]] glm::dvec4 read_key_numbers(const FieldInfo& field, std::int32_t element, const assets::JsonValue& value);

/// A tangent of such a key: `count` finite numbers, or one that is not in an array.
[[nodiscard]] glm::dvec4 read_key_tangent(int count, const assets::JsonValue& value);

/// The value of a key for a flag, a whole number, a text or an option. Throws Error for what the field can't hold.
[[nodiscard]] FieldValue read_key_choice(const FieldInfo& field, const assets::JsonValue& value);

} // namespace hachure
