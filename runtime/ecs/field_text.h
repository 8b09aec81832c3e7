#pragma once

#include <hachure/runtime/ecs/field_info.h>

#include <string>
#include <string_view>

namespace hachure {

/// Reads a field's value as a user writes it: `true` and `false`; numbers; vectors as `1,0,0` or `1 0 0`; quaternions
/// as x, y, z, w; colours as numbers in linear light, or as `#rrggbb` or `#rrggbbaa` in sRGB (alpha linear, and 1 where
/// the field has one and the text has none); the name of an option; entities as `null` or as `12v3`, slot and
/// generation; text as it is. Spaces around the value are ignored, except in text. Throws Error(field.path, fault) on
/// anything else, and on what FieldInfo::fault finds.
FieldValue parse_field(const FieldInfo& field, std::string_view text);

/// Writes a value of the field so that `parse_field` gives exactly the same value back, in the fewest significant
/// digits; vectors and colours as `1 0 0`. `value` has the alternative that the field's default has.
std::string format_field(const FieldInfo& field, const FieldValue& value);

} // namespace hachure
