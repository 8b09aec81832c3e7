#include <hachure/components/camera.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/assets/text_file.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/styles/style.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hachure {
namespace {

using nlohmann::json;

constexpr std::size_t max_style_bytes = std::size_t{1} << 20;

StyleComponent parse_component(const TypeRegistry& types, std::string_view subject, const std::string& name,
                               const json& fields, const std::string& pointer) {
    const TypeInfo* type = types.find(name);
    if (!type) throw Error(subject, "there is no component '" + name + "'", pointer);
    return {type, fields_from_json(*type, fields, {subject, pointer})};
}

std::vector<StyleComponent> parse_components(const TypeRegistry& types, std::string_view subject, const json& style,
                                             const char* kind) {
    std::vector<StyleComponent> result;
    const std::string pointer = std::string("/") + kind;
    const auto found = style.find(kind);
    if (found == style.end()) return result;
    if (!found->is_object()) throw Error(subject, "the components of a style are an object", pointer);
    for (const auto& [name, fields] : found->items())
        result.push_back(parse_component(types, subject, name, fields, pointer + "/" + name));
    return result;
}

void add_components(World& world, Entity entity, std::span<const StyleComponent> components) {
    for (const StyleComponent& component : components) {
        void* value = component.type->add_default(world, entity);
        for (const auto& [field, field_value] : component.fields) field->set(value, field_value);
    }
}

std::string known_names() {
    std::string names;
    for (const BuiltInStyle& style : built_in_styles()) names += (names.empty() ? "" : ", ") + std::string(style.name);
    return names;
}

} // namespace

Style parse_style(const TypeRegistry& types, std::string_view subject, std::string_view text) {
    json document;
    try {
        document = json::parse(text);
    } catch (const json::parse_error& error) {
        throw Error(subject, "is not JSON", "byte " + std::to_string(error.byte));
    }
    if (!document.is_object() || !document.contains("hachure_style"))
        throw Error(subject, "is not a style: it lacks \"hachure_style\"");
    if (document["hachure_style"] != 1) throw Error(subject, "has a version that is not known", "/hachure_style");
    for (const auto& [key, value] : document.items())
        if (key != "hachure_style" && key != "name" && key != "doc" && key != "surface" && key != "camera")
            throw Error(subject, "a style has no '" + key + "'", "/" + key);
    Style style;
    style.name = document.value("name", json("")).is_string() ? document.value("name", "") : "";
    style.doc = document.value("doc", json("")).is_string() ? document.value("doc", "") : "";
    style.surface = parse_components(types, subject, document, "surface");
    style.camera = parse_components(types, subject, document, "camera");
    return style;
}

Style find_style(const TypeRegistry& types, std::string_view name_or_path) {
    for (const BuiltInStyle& style : built_in_styles())
        if (name_or_path == style.name) return parse_style(types, style.name, style.text);
    const std::filesystem::path path(name_or_path);
    if (path.extension() != ".json")
        throw Error(name_or_path, "there is no such style; there are " + known_names() + ", or a preset FILE.json");
    return parse_style(types, name_or_path, assets::read_text_file(path, max_style_bytes));
}

void apply_style(World& world, const TypeRegistry& types, const Style& style) {
    for (const Entity entity : types.find("surface")->entities(world)) add_components(world, entity, style.surface);
    for (const Entity entity : types.find("camera")->entities(world)) add_components(world, entity, style.camera);
}

void apply_style(World& world, const Style& style, Entity root) {
    const auto apply = [&](Entity entity) {
        if (world.has<Surface>(entity)) add_components(world, entity, style.surface);
        if (world.has<Camera>(entity)) add_components(world, entity, style.camera);
    };
    apply(root);
    world.for_each_descendant(root, apply);
}

} // namespace hachure
