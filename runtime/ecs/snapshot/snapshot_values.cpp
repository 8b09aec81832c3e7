#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/snapshot/snapshot_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hachure::detail {
namespace {

// So that a quaternion can be copied as it lies in memory.
static_assert(offsetof(glm::quat, x) == 0 && offsetof(glm::quat, w) == 12, "quaternions lie as x, y, z, w");

struct CodeInfo {
    std::string_view name;
    std::size_t width;
};

/// In the order of the codes, from 1.
constexpr std::array<CodeInfo, 14> codes{{{"boolean", 1},
                                          {"int32", 4},
                                          {"int64", 8},
                                          {"uint32", 4},
                                          {"uint64", 8},
                                          {"float32", 4},
                                          {"float64", 8},
                                          {"vec2", 8},
                                          {"vec3", 12},
                                          {"vec4", 16},
                                          {"quaternion", 16},
                                          {"text", 0},
                                          {"enumeration", 2},
                                          {"entity", 8}}};

const CodeInfo& info(ValueCode code) { return codes[static_cast<std::size_t>(code) - 1]; }

bool is_number(ValueCode code) { return code >= ValueCode::int32 && code <= ValueCode::float64; }

template <class T> T copy(Bytes bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

template <class Integer> std::optional<FieldValue> to_integer(const FieldValue& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value))
        return std::in_range<Integer>(*number) ? std::optional<FieldValue>(static_cast<Integer>(*number))
                                               : std::nullopt;
    if (const auto* number = std::get_if<std::uint64_t>(&value))
        return std::in_range<Integer>(*number) ? std::optional<FieldValue>(static_cast<Integer>(*number))
                                               : std::nullopt;
    const auto* real = std::get_if<double>(&value);
    // The largest integers are no doubles, but one more than them is.
    const double end = std::ldexp(1.0, std::numeric_limits<Integer>::digits);
    const double begin = std::is_signed_v<Integer> ? -end : 0.0;
    if (!real || !(*real >= begin && *real < end) || *real != std::floor(*real)) return std::nullopt;
    return static_cast<Integer>(*real);
}

std::optional<FieldValue> to_real(const FieldValue& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value)) return static_cast<double>(*number);
    if (const auto* number = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*number);
    const auto* real = std::get_if<double>(&value);
    return real ? std::optional<FieldValue>(*real) : std::nullopt;
}

} // namespace

ValueCode value_code(const FieldInfo& field) {
    switch (field.kind) {
    case FieldKind::boolean:
        return ValueCode::boolean;
    case FieldKind::integer:
        if (std::holds_alternative<std::int64_t>(field.default_value))
            return field.bits == 32 ? ValueCode::int32 : ValueCode::int64;
        return field.bits == 32 ? ValueCode::uint32 : ValueCode::uint64;
    case FieldKind::real:
        return field.bits == 32 ? ValueCode::float32 : ValueCode::float64;
    case FieldKind::vec2:
        return ValueCode::vec2;
    case FieldKind::vec3:
        return ValueCode::vec3;
    case FieldKind::vec4:
        return ValueCode::vec4;
    case FieldKind::quaternion:
        return ValueCode::quaternion;
    case FieldKind::color:
        return std::holds_alternative<glm::vec3>(field.default_value) ? ValueCode::vec3 : ValueCode::vec4;
    case FieldKind::text:
        return ValueCode::text;
    case FieldKind::enumeration:
        return ValueCode::enumeration;
    case FieldKind::entity:
        return ValueCode::entity;
    }
    HACHURE_ASSERT(false, "a field has a kind");
}

std::optional<ValueCode> value_code(std::uint8_t number) {
    return number >= 1 && number <= codes.size() ? std::optional(static_cast<ValueCode>(number)) : std::nullopt;
}

std::string_view to_string(ValueCode code) { return info(code).name; }

std::size_t width(ValueCode code) { return info(code).width; }

Bytes take_value(ByteReader& in, ValueCode code) {
    return in.take(code == ValueCode::text ? in.number<std::uint32_t>() : width(code));
}

std::optional<FieldValue> decode_value(ValueCode code, Bytes bytes, const OptionNames& options) {
    switch (code) {
    case ValueCode::boolean: {
        const auto byte = copy<std::uint8_t>(bytes);
        return byte <= 1 ? std::optional<FieldValue>(byte == 1) : std::nullopt;
    }
    case ValueCode::int32:
        return std::int64_t{copy<std::int32_t>(bytes)};
    case ValueCode::int64:
        return copy<std::int64_t>(bytes);
    case ValueCode::uint32:
        return std::uint64_t{copy<std::uint32_t>(bytes)};
    case ValueCode::uint64:
        return copy<std::uint64_t>(bytes);
    case ValueCode::float32:
        return double{copy<float>(bytes)};
    case ValueCode::float64:
        return copy<double>(bytes);
    case ValueCode::vec2:
        return copy<glm::vec2>(bytes);
    case ValueCode::vec3:
        return copy<glm::vec3>(bytes);
    case ValueCode::vec4:
        return copy<glm::vec4>(bytes);
    case ValueCode::quaternion:
        return copy<glm::quat>(bytes);
    case ValueCode::text:
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    case ValueCode::enumeration: {
        const auto index = copy<std::uint16_t>(bytes);
        return index < options.size() ? std::optional<FieldValue>(std::string(options[index])) : std::nullopt;
    }
    case ValueCode::entity:
        return copy<Entity>(bytes);
    }
    return std::nullopt;
}

void encode_value(ByteWriter& out, ValueCode code, const FieldValue& value, const OptionNames& options) {
    switch (code) {
    case ValueCode::boolean:
        return out.number(static_cast<std::uint8_t>(std::get<bool>(value)));
    case ValueCode::int32:
        return out.number(static_cast<std::int32_t>(std::get<std::int64_t>(value)));
    case ValueCode::int64:
        return out.number(std::get<std::int64_t>(value));
    case ValueCode::uint32:
        return out.number(static_cast<std::uint32_t>(std::get<std::uint64_t>(value)));
    case ValueCode::uint64:
        return out.number(std::get<std::uint64_t>(value));
    case ValueCode::float32:
        return out.number(static_cast<float>(std::get<double>(value)));
    case ValueCode::float64:
        return out.number(std::get<double>(value));
    case ValueCode::vec2:
        return out.number(std::get<glm::vec2>(value));
    case ValueCode::vec3:
        return out.number(std::get<glm::vec3>(value));
    case ValueCode::vec4:
        return out.number(std::get<glm::vec4>(value));
    case ValueCode::quaternion:
        return out.number(std::get<glm::quat>(value));
    case ValueCode::entity:
        return out.number(std::get<Entity>(value));
    case ValueCode::text:
        out.number(static_cast<std::uint32_t>(std::get<std::string>(value).size()));
        return out.bytes(bytes_of(std::get<std::string>(value)));
    case ValueCode::enumeration: {
        const auto option = std::ranges::find(options, std::get<std::string>(value));
        HACHURE_ASSERT(option != options.end(), "an option that exists is written");
        return out.number(static_cast<std::uint16_t>(option - options.begin()));
    }
    }
}

std::optional<FieldValue> convert_number(const FieldValue& value, ValueCode code) {
    switch (code) {
    case ValueCode::int32:
    case ValueCode::int64:
        return to_integer<std::int64_t>(value);
    case ValueCode::uint32:
    case ValueCode::uint64:
        return to_integer<std::uint64_t>(value);
    case ValueCode::float32:
    case ValueCode::float64:
        return to_real(value);
    default:
        return std::nullopt;
    }
}

bool is_convertible(ValueCode from, ValueCode to) { return from == to || (is_number(from) && is_number(to)); }

OptionNames option_names(const FieldInfo& field) { return {field.options.begin(), field.options.end()}; }

} // namespace hachure::detail
