#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/scene/migrate_scene.h>
#include <hachure/systems/scene/scene_schema.h>
#include <hachure/systems/styles/style.h>

#include <cmath>
#include <string>

namespace hachure {
namespace {

using Json = nlohmann::ordered_json;

Json text_schema(std::string_view doc) { return {{"type", "string"}, {"description", doc}}; }

Json number_schema(const FieldInfo& field, const char* type) {
    Json result{{"type", type}};
    if (field.range && std::isfinite(field.range->min)) result["minimum"] = field.range->min;
    if (field.range && std::isfinite(field.range->max)) result["maximum"] = field.range->max;
    return result;
}

Json array_schema(const FieldInfo& field, int size) {
    return {{"type", "array"}, {"items", number_schema(field, "number")}, {"minItems", size}, {"maxItems", size}};
}

/// A value as it is written; besides that, most may be what a user types on the command line.
Json value_schema(const FieldInfo& field) {
    switch (field.kind) {
    case FieldKind::boolean:
        return {{"type", "boolean"}};
    case FieldKind::integer:
        return number_schema(field, "integer");
    case FieldKind::real:
        return number_schema(field, "number");
    case FieldKind::vec2:
        return array_schema(field, 2);
    case FieldKind::vec3:
        return array_schema(field, 3);
    case FieldKind::vec4:
    case FieldKind::quaternion:
        return array_schema(field, 4);
    case FieldKind::color: {
        const bool alpha = std::holds_alternative<glm::vec4>(field.default_value);
        const Json code{{"type", "string"},
                        {"pattern", alpha ? "^#[0-9a-fA-F]{6}([0-9a-fA-F]{2})?$" : "^#[0-9a-fA-F]{6}$"}};
        return {{"anyOf", Json::array({array_schema(field, alpha ? 4 : 3), code})}};
    }
    case FieldKind::text:
        return {{"type", "string"}};
    case FieldKind::enumeration:
        return {{"enum", field.options}};
    case FieldKind::entity:
        return {{"type", Json::array({"string", "null"})}};
    }
    return Json::object();
}

Json field_schema(const FieldInfo& field) {
    Json result = value_schema(field);
    result["description"] = field.unit.empty() ? field.doc : field.doc + " [" + field.unit + "]";
    result["default"] = to_json(field, field.default_value);
    return result;
}

Json component_schema(const TypeInfo& type) {
    Json fields = Json::object();
    for (const FieldInfo& field : type.fields) fields[field.name] = field_schema(field);
    return {{"description", type.doc}, {"type", Json::array({"object", "null"})}, {"properties", std::move(fields)}};
}

Json components_schema(const TypeRegistry& types, std::string_view doc) {
    Json components = Json::object();
    for (const TypeInfo& type : types.types()) components[type.name] = {{"$ref", "#/$defs/components/" + type.name}};
    return {{"description", doc}, {"type", "object"}, {"properties", std::move(components)}};
}

Json entity_schema(const World& world, const TypeRegistry& types) {
    Json keys;
    keys["model"] = text_schema("the file of a model that stands at the entity");
    keys["scene"] = text_schema("the file of another scene that stands below the entity");
    keys["below"] = text_schema("path of names: the part of the model or scene around it that the entity stands below");
    keys["look"] = text_schema("one of the looks, for every surface at and below the entity");
    keys["overrides"] = {
        {"description", "components by path of names below the entity, for parts of its model or scene"},
        {"type", "object"},
        {"additionalProperties", {{"$ref", "#/$defs/set"}}}};
    keys["children"] = {{"description", "the entities that stand on this one"},
                        {"type", "array"},
                        {"items", {{"$ref", "#/$defs/entity"}}}};
    for (const TypeInfo& type : types.types()) keys[type.name] = {{"$ref", "#/$defs/components/" + type.name}};
    if (const SceneParts* parts = world.find_resource<SceneParts>())
        for (const ScenePart& part : parts->parts) {
            Json schema = part.schema.is_object() ? Json(part.schema) : Json::object();
            schema["description"] = part.doc;
            keys[part.name] = std::move(schema);
        }
    return {{"type", "object"}, {"properties", std::move(keys)}};
}

} // namespace

Json scene_schema(const World& world, const TypeRegistry& types) {
    Json styles = Json::array();
    for (const BuiltInStyle& style : built_in_styles()) styles.push_back(style.name);
    Json components = Json::object();
    for (const TypeInfo& type : types.types()) components[type.name] = component_schema(type);
    if (components.contains("name"))
        components["name"] = {{"description", "what the entity is called"},
                              {"type", Json::array({"string", "object", "null"})}};
    Json keys;
    keys["hachure_scene"] = {{"description", "the version of the format"}, {"const", scene_version}};
    keys["$schema"] = text_schema("where text editors find this schema");
    keys["doc"] = text_schema("one line that says what the scene shows");
    keys["style"] = {
        {"description", "what all surfaces and the camera carry"},
        {"anyOf", Json::array({Json{{"enum", styles}}, Json{{"type", "string"}, {"pattern", "\\.json$"}}})}};
    keys["looks"] = {{"description", "sets of components by name, for entities to refer to"},
                     {"type", "object"},
                     {"additionalProperties", {{"$ref", "#/$defs/set"}}}};
    keys["entities"] = {
        {"description", "what the scene is made of"}, {"type", "array"}, {"items", {{"$ref", "#/$defs/entity"}}}};
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "Hachure scene"},
            {"type", "object"},
            {"required", Json::array({"hachure_scene"})},
            {"properties", std::move(keys)},
            {"$defs",
             {{"entity", entity_schema(world, types)},
              {"set", components_schema(types, "components with the fields that differ; null takes a component away")},
              {"components", std::move(components)}}}};
}

} // namespace hachure
