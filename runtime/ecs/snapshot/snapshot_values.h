#pragma once

#include <hachure/runtime/ecs/field_info.h>
#include <hachure/runtime/ecs/snapshot/snapshot_bytes.h>

#include <optional>
#include <string_view>
#include <vector>

namespace hachure::detail {

/// How a value is written in a snapshot. The numbers are part of the format. All but text and enumerations are written
/// as they lie in memory.
enum class ValueCode : std::uint8_t {
    boolean = 1, ///< one byte, 0 or 1
    int32 = 2,
    int64 = 3,
    uint32 = 4,
    uint64 = 5,
    float32 = 6,
    float64 = 7,
    vec2 = 8,
    vec3 = 9,
    vec4 = 10,
    quaternion = 11,  ///< x, y, z, w
    text = 12,        ///< 32-bit length, bytes
    enumeration = 13, ///< 16-bit index into the names that the column gives
    entity = 14,      ///< slot, generation
};

using OptionNames = std::vector<std::string_view>;

/// How values of the field are written.
ValueCode value_code(const FieldInfo& field);

/// Nothing for a code that does not exist.
std::optional<ValueCode> value_code(std::uint8_t number);

/// For messages: "float32".
std::string_view to_string(ValueCode code);

/// Bytes per value; 0 for text, whose values differ in length.
std::size_t width(ValueCode code);

/// Takes one value. Throws Error at the end of the bytes.
Bytes take_value(ByteReader& in, ValueCode code);

/// The value that `bytes` from `take_value` hold; nothing for a boolean that is neither 0 nor 1, and for an index
/// beyond the options.
std::optional<FieldValue> decode_value(ValueCode code, Bytes bytes, const OptionNames& options);

/// Writes a value that belongs to the code, of an option that exists.
void encode_value(ByteWriter& out, ValueCode code, const FieldValue& value, const OptionNames& options);

/// `value` as the alternative that `code` calls for: equal for integers, rounded for floating-point numbers. Nothing
/// when there is no such number, or either is no number.
std::optional<FieldValue> convert_number(const FieldValue& value, ValueCode code);

/// Whether values of one code can be converted to the other.
bool is_convertible(ValueCode from, ValueCode to);

/// The names of the field's options; they point into the field.
OptionNames option_names(const FieldInfo& field);

} // namespace hachure::detail
