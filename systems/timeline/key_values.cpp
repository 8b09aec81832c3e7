#include <hachure/runtime/ecs/field_text.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/timeline/key_values.h>
#include <hachure/systems/timeline/track_writer.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace hachure {
namespace {

using assets::JsonValue;

constexpr double any = std::numeric_limits<double>::max();

void require_fit(const FieldInfo& field, const FieldValue& fitted, const JsonValue& value) {
    if (const std::string fault = field.fault(fitted); !fault.empty()) value.fail(field.path + ": " + fault);
}

/// As many numbers as asked for: one by itself, more in an array.
glm::dvec4 read_array(int count, const JsonValue& value) {
    glm::dvec4 numbers(0.0);
    if (count == 1) {
        numbers.x = value.number(-any, any);
        return numbers;
    }
    if (!value.json().is_array() || value.json().size() != static_cast<std::size_t>(count))
        value.fail(fmt::format("these are not {} numbers", count));
    for (int i = 0; i < count; ++i) numbers[i] = value.at(static_cast<std::size_t>(i)).number(-any, any);
    return numbers;
}

struct Numbers {
    glm::dvec4 operator()(double v) const { return {v, 0.0, 0.0, 0.0}; }
    glm::dvec4 operator()(const glm::vec2& v) const { return {v.x, v.y, 0.0, 0.0}; }
    glm::dvec4 operator()(const glm::vec3& v) const { return {v.x, v.y, v.z, 0.0}; }
    glm::dvec4 operator()(const glm::vec4& v) const { return {v.x, v.y, v.z, v.w}; }
    glm::dvec4 operator()(const glm::quat& q) const { return {q.x, q.y, q.z, q.w}; }
    template <class Other> glm::dvec4 operator()(const Other&) const { return glm::dvec4(0.0); }
};

/// As the field has it: of the same alternative as its default.
FieldValue field_value(const FieldInfo& field, const glm::dvec4& numbers) {
    const glm::vec4 v(numbers);
    switch (field.default_value.index()) {
    case FieldValue(glm::vec2()).index():
        return glm::vec2(v);
    case FieldValue(glm::vec3()).index():
        return glm::vec3(v);
    case FieldValue(glm::vec4()).index():
        return v;
    case FieldValue(glm::quat()).index():
        return glm::quat(v.w, v.x, v.y, v.z);
    default:
        return numbers.x;
    }
}

FieldValue parse(const FieldInfo& field, const JsonValue& value) {
    try {
        return parse_field(field, value.string());
    } catch (const Error& error) {
        value.fail(error.what());
    }
}

} // namespace

glm::dvec4 read_key_numbers(const FieldInfo& field, std::int32_t element, const JsonValue& value) {
    if (element >= 0) {
        const double number = value.number(-any, any);
        glm::dvec4 numbers = std::visit(Numbers{}, field.default_value);
        numbers[element] = number;
        require_fit(field, field_value(field, numbers), value);
        return {number, 0.0, 0.0, 0.0};
    }
    if (field.kind == FieldKind::color && value.json().is_string()) return std::visit(Numbers{}, parse(field, value));
    const glm::dvec4 numbers = read_array(numbers_of(field), value);
    require_fit(field, field_value(field, numbers), value);
    if (field.kind != FieldKind::quaternion) return numbers;
    return numbers / std::sqrt(glm::dot(numbers, numbers));
}

glm::dvec4 read_key_tangent(int count, const JsonValue& value) { return read_array(count, value); }

FieldValue read_key_choice(const FieldInfo& field, const JsonValue& value) {
    FieldValue result;
    if (field.kind == FieldKind::boolean) {
        result = value.flag();
    } else if (field.kind == FieldKind::integer) {
        if (!value.json().is_number_integer()) value.fail("this is no whole number");
        if (!std::holds_alternative<std::uint64_t>(field.default_value)) {
            if (value.json().is_number_unsigned() &&
                value.json().get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()})
                value.fail(field.path + ": the number is too large");
            result = value.json().get<std::int64_t>();
        } else {
            if (!value.json().is_number_unsigned()) value.fail(field.path + ": the number is negative");
            result = value.json().get<std::uint64_t>();
        }
    } else {
        result = value.string();
    }
    require_fit(field, result, value);
    return result;
}

} // namespace hachure
