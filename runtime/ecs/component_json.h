#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace hachure {

/// Which fields `to_json` writes.
enum class JsonFields {
    differing, ///< those that differ from their defaults
    all,
};

/// Where a JSON value comes from, for errors: they are `SUBJECT: component.field: fault (POINTER/field)`.
struct JsonPlace {
    std::string_view subject; ///< a file's name; may be empty
    std::string pointer;      ///< the JSON pointer of the value
    /// Says of a pointer where it stands, such as its line and column; empty where that is the pointer itself.
    std::function<std::string(std::string_view pointer)> where = {};
};

/// A field's value as JSON; see `to_json` of a component.
nlohmann::json to_json(const FieldInfo& field, const FieldValue& value);

/// Reads one field, as `fields_from_json` reads it. Throws Error(field.path, fault) without a place.
FieldValue field_from_json(const FieldInfo& field, const nlohmann::json& value);

/// A component as a JSON object: booleans and numbers as such, vectors, colours and quaternions (x, y, z, w) as arrays,
/// texts, options and entities ("12v3") as strings, the null entity as null.
nlohmann::json to_json(const TypeInfo& type, const void* component, JsonFields which = JsonFields::differing);

/// Reads what `to_json` writes, and for all but texts also a string as a user would type it on the command line, such
/// as "#ff8800". Throws Error for what is no object, for fields that the type does not have, and for values that their
/// fields can't hold.
FieldValues fields_from_json(const TypeInfo& type, const nlohmann::json& fields, const JsonPlace& place = {});

/// Writes the fields that `fields` has into the component; the others stay. Throws as `fields_from_json`, and has
/// written nothing then.
void from_json(const TypeInfo& type, void* component, const nlohmann::json& fields, const JsonPlace& place = {});

} // namespace hachure
