#include <hachure/runtime/ecs/snapshot/snapshot_field.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::detail {
namespace {

[[noreturn]] void fail(const FieldInfo& field, std::string_view subject, std::string_view fault) {
    throw Error(subject, fmt::format("{}: {}", field.path, fault));
}

/// Whether the numbers are finite and in the field's range; `values` holds nothing else.
template <class Real> bool all_in_range(const FieldInfo& field, Bytes values) {
    const auto limit = std::numeric_limits<Real>::max();
    const auto min = field.range ? static_cast<Real>(field.range->min) : -limit;
    const auto max = field.range ? static_cast<Real>(field.range->max) : limit;
    bool fine = true; // no early exit, so that it can be vectorised
    for (std::size_t at = 0; at < values.size(); at += sizeof(Real)) {
        Real number;
        std::memcpy(&number, values.data() + at, sizeof number);
        fine &= number >= min && number <= max && std::abs(number) <= limit; // NaN compares false
    }
    return fine;
}

/// Whether the quaternions are well within what FieldInfo::fault takes for length 1.
bool all_of_length_one(Bytes values) {
    bool fine = true;
    for (std::size_t at = 0; at < values.size(); at += 4 * sizeof(float)) {
        float q[4];
        std::memcpy(q, values.data() + at, sizeof q);
        const float square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        fine &= square >= 0.999f && square <= 1.001f;
    }
    return fine;
}

/// Quick checks of many values. False means: look closer.
bool surely_fine(const FieldInfo& field, ValueCode code, Bytes values) {
    switch (code) {
    case ValueCode::float32:
    case ValueCode::vec2:
    case ValueCode::vec3:
    case ValueCode::vec4:
        return all_in_range<float>(field, values);
    case ValueCode::float64:
        return all_in_range<double>(field, values);
    case ValueCode::int32:
    case ValueCode::int64:
    case ValueCode::uint32:
    case ValueCode::uint64:
        return !field.range;
    case ValueCode::boolean:
        return std::ranges::all_of(values, [](std::byte byte) { return byte <= std::byte{1}; });
    case ValueCode::quaternion:
        return all_of_length_one(values);
    case ValueCode::text:
        return true;
    default:
        return false;
    }
}

/// As encode_value writes it, without the length of a text.
std::vector<std::byte> encoded(const FieldInfo& field, ValueCode code, const FieldValue& value) {
    std::vector<std::byte> result;
    ByteWriter out(result);
    encode_value(out, code, value, option_names(field));
    if (code == ValueCode::text) result.erase(result.begin(), result.begin() + 4);
    return result;
}

/// Many rows may share one long text of a snapshot; in the world each has its own.
constexpr std::uint64_t max_default_text_bytes = std::uint64_t{1} << 28;

void check_default_size(const FieldColumn& column, std::string_view subject) {
    const std::uint64_t rows = column.given.of - column.given.count;
    if (column.code == ValueCode::text && column.default_value.size() * rows > max_default_text_bytes)
        fail(*column.field, subject,
             fmt::format("{} components with {} bytes of text are too many", rows, column.default_value.size()));
}

/// Turns one value of the column into one of the field.
FieldValue convert(const Column& column, const FieldInfo& field, ValueCode code, Bytes bytes,
                   std::string_view subject) {
    const auto value = decode_value(column.code, bytes, column.options);
    if (!value) fail(field, subject, "a value is none of its kind");
    const auto converted = column.code == code ? value : convert_number(*value, code);
    if (!converted)
        fail(field, subject,
             fmt::format("{} of the snapshot does not fit {} here", to_string(column.code), to_string(code)));
    if (const std::string fault = field.fault(*converted); !fault.empty()) fail(field, subject, fault);
    return *converted;
}

FieldColumn convert(const Column& column, const FieldInfo& field, ValueCode code, std::string_view subject,
                    ColumnArena& arena) {
    auto& values = arena.emplace_back();
    ByteWriter out(values);
    const OptionNames options = option_names(field);
    ByteReader in(column.values, subject);
    for (std::uint32_t i = 0; i < column.given.count; ++i)
        encode_value(out, code, convert(column, field, code, take_value(in, column.code), subject), options);
    FieldColumn result{&field, code, column.given, values, {}, false};
    if (column.given.count < column.given.of)
        result.default_value =
            arena.emplace_back(encoded(field, code, convert(column, field, code, column.default_value, subject)));
    return result;
}

bool same_form(const Column& column, const FieldInfo& field, ValueCode code) {
    return column.code == code && (code != ValueCode::enumeration || std::ranges::equal(column.options, field.options));
}

} // namespace

std::string values_fault(const FieldInfo& field, std::uint32_t count, Bytes values) {
    const ValueCode code = value_code(field);
    if (surely_fine(field, code, values)) return {};
    const OptionNames options = option_names(field);
    ByteReader in(values, field.path);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto value = decode_value(code, take_value(in, code), options);
        if (!value) return "a value is none of its kind";
        if (std::string fault = field.fault(*value); !fault.empty()) return fault;
    }
    return {};
}

FieldColumn match_field(const Column& column, const FieldInfo& field, std::string_view subject, ColumnArena& arena) {
    const ValueCode code = value_code(field);
    if (!is_convertible(column.code, code))
        fail(field, subject, fmt::format("is {} in the snapshot and {} here", to_string(column.code), to_string(code)));
    FieldColumn result{&field, code, column.given, column.values, column.default_value, false};
    if (!same_form(column, field, code)) {
        result = convert(column, field, code, subject, arena);
    } else {
        if (const std::string fault = values_fault(field, column.given.count, column.values); !fault.empty())
            fail(field, subject, fault);
        if (column.given.count < column.given.of) convert(column, field, code, column.default_value, subject);
    }
    // The default of a column that gives every row a value is nobody's.
    if (column.given.count < column.given.of)
        result.other_default = !std::ranges::equal(result.default_value, encoded(field, code, field.default_value));
    if (result.other_default) check_default_size(result, subject);
    return result;
}

} // namespace hachure::detail
