#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>

namespace hachure {
namespace {

using nlohmann::json;

/// A float as the shortest decimal number that is read as it: 0.1, and not 0.10000000149011612.
json shortest(float number) {
    const std::string text = fmt::format("{}", number);
    double result = 0;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

template <int n> json array_of(const glm::vec<n, float>& vector) {
    json result = json::array();
    for (int i = 0; i < n; ++i) result.push_back(shortest(vector[i]));
    return result;
}

struct Write {
    const FieldInfo& field;

    json operator()(bool value) const { return value; }
    json operator()(std::int64_t value) const { return value; }
    json operator()(std::uint64_t value) const { return value; }
    json operator()(double value) const { return field.bits == 32 ? shortest(static_cast<float>(value)) : json(value); }
    json operator()(const glm::vec2& value) const { return array_of(value); }
    json operator()(const glm::vec3& value) const { return array_of(value); }
    json operator()(const glm::vec4& value) const { return array_of(value); }
    json operator()(const glm::quat& q) const { return array_of(glm::vec4(q.x, q.y, q.z, q.w)); }
    json operator()(const std::string& value) const { return value; }
    json operator()(Entity value) const { return value ? json(to_string(value)) : json(); }
};

bool takes_array(const FieldInfo& field) {
    switch (field.kind) {
    case FieldKind::vec2:
    case FieldKind::vec3:
    case FieldKind::vec4:
    case FieldKind::quaternion:
    case FieldKind::color:
        return true;
    default:
        return false;
    }
}

/// What a user would type for the value. It loses no digit: numbers are written with as many as tell them apart.
std::string field_text(const FieldInfo& field, const json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_null() && field.kind == FieldKind::entity) return "null";
    if ((value.is_boolean() || value.is_number()) && field.kind != FieldKind::text) return value.dump();
    if (!value.is_array() || !takes_array(field))
        throw Error(field.path, fmt::format("the value is no {}", to_string(field.kind)));
    std::string text;
    for (const json& element : value) {
        if (!element.is_number()) throw Error(field.path, "an element is not a number");
        text += (text.empty() ? "" : " ") + element.dump();
    }
    return text;
}

/// The place of a value, or of a field of it.
std::string place_text(const JsonPlace& place, std::string_view field = {}) {
    const std::string pointer = field.empty() ? place.pointer : place.pointer + "/" + std::string(field);
    return place.where ? place.where(pointer) : pointer;
}

} // namespace

json to_json(const FieldInfo& field, const FieldValue& value) { return std::visit(Write{field}, value); }

FieldValue field_from_json(const FieldInfo& field, const json& value) {
    return parse_field(field, field_text(field, value));
}

json to_json(const TypeInfo& type, const void* component, JsonFields which) {
    json result = json::object();
    for (const FieldInfo& field : type.fields) {
        const FieldValue value = field.get(component);
        if (which == JsonFields::all || value != field.default_value) result[field.name] = to_json(field, value);
    }
    return result;
}

FieldValues fields_from_json(const TypeInfo& type, const json& fields, const JsonPlace& place) {
    if (!fields.is_object())
        throw Error(place.subject, type.name + ": the fields of a component are an object", place_text(place));
    FieldValues result;
    for (const auto& [name, value] : fields.items()) {
        const FieldInfo* field = type.field(name);
        if (!field)
            throw Error(place.subject, "component '" + type.name + "' has no field '" + name.substr(0, 60) + "'",
                        place_text(place, name));
        try {
            result.emplace_back(field, field_from_json(*field, value));
        } catch (const Error& error) {
            throw Error(place.subject, error.what(), place_text(place, name));
        }
    }
    return result;
}

void from_json(const TypeInfo& type, void* component, const json& fields, const JsonPlace& place) {
    for (const auto& [field, value] : fields_from_json(type, fields, place)) field->set(component, value);
}

} // namespace hachure
