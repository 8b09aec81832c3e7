#include <hachure/components/surface.h>
#include <hachure/runtime/assets/json_place.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>
#include <hachure/systems/scene/scene_fields.h>

#include <utility>

namespace hachure {
namespace {

using nlohmann::json;

void read_field(const FieldInfo& field, const json& value, const SceneFile& file, const std::string& pointer,
                SceneFaults& faults, SaidComponent& said) {
    if (field.kind == FieldKind::entity && value.is_string()) {
        said.entities.push_back({&field, value.get<std::string>(), pointer + "/" + field.name});
        return;
    }
    try {
        FieldValue read = field_from_json(field, value);
        if (auto* path = std::get_if<std::string>(&read); path && is_file_field(field) && !path->empty()) {
            *path = file.resolve(*path).string();
            if (const std::string& wrong = faults.file_fault(field, *path); !wrong.empty())
                faults.fault(file, pointer + "/" + field.name, wrong);
        }
        said.fields.emplace_back(&field, std::move(read));
    } catch (const Error& error) {
        faults.fault(file, pointer + "/" + field.name, error.what());
    }
}

} // namespace

SceneTypes::SceneTypes(const TypeRegistry& types) : types_(&types) {
    for (const TypeInfo& type : types.types()) by_name_.emplace(type.name, &type);
}

const TypeInfo* SceneTypes::find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found != by_name_.end() ? found->second : nullptr;
}

bool read_component(const TypeInfo& type, const json& value, const SceneFile& file, const std::string& pointer,
                    SceneFaults& faults, SaidComponent& said, json* unknown) {
    said.type = &type;
    said.removed = value.is_null();
    said.fields.clear();
    said.entities.clear();
    if (said.removed) return true;
    if (type.name == "name" && value.is_string()) {
        said.fields.emplace_back(type.field("text"), value.get<std::string>());
        return true;
    }
    if (!value.is_object()) {
        faults.fault(file, pointer, type.name + ": the fields of a component are an object");
        return false;
    }
    for (const auto& [name, field_value] : value.items()) {
        if (const FieldInfo* field = type.field(name)) {
            read_field(*field, field_value, file, pointer, faults, said);
            continue;
        }
        faults.warn(file, pointer + "/" + assets::pointer_token(name),
                    "component '" + type.name + "' has no field '" + name.substr(0, 60) + "'");
        if (unknown) (*unknown)[type.name][name] = field_value;
    }
    return true;
}

std::vector<SaidComponent> read_components(const SceneTypes& types, const json& value, const SceneFile& file,
                                           const std::string& pointer, SceneFaults& faults) {
    std::vector<SaidComponent> result;
    if (!value.is_object()) {
        faults.fault(file, pointer, "a set of components is an object");
        return result;
    }
    for (const auto& [name, fields] : value.items()) {
        const std::string place = pointer + "/" + assets::pointer_token(name);
        const TypeInfo* type = types.find(name);
        SaidComponent said;
        if (!type)
            faults.warn(file, place, "there is no component '" + name.substr(0, 60) + "'");
        else if (read_component(*type, fields, file, place, faults, said, nullptr))
            result.push_back(std::move(said));
    }
    return result;
}

json with_paths(const SceneTypes& types, json components,
                const std::function<std::string(const std::string&)>& change) {
    if (!components.is_object()) return components;
    for (auto& [name, fields] : components.items()) {
        const TypeInfo* type = types.find(name);
        if (!type || !fields.is_object()) continue;
        for (const FieldInfo& field : type->fields)
            if (is_file_field(field) && fields.contains(field.name) && fields[field.name].is_string() &&
                fields[field.name] != "")
                fields[field.name] = change(fields[field.name].get<std::string>());
    }
    return components;
}

bool apply(World& world, Entity entity, const SaidComponent& said) {
    const TypeInfo& type = *said.type;
    if (said.removed) {
        type.remove(world, entity);
        return true;
    }
    void* component = type.find_mutable(world, entity);
    if (!component && type.component == detail::component_id<Surface>()) return false;
    if (!component) component = type.add_default(world, entity);
    for (const auto& [field, value] : said.fields) field->set(component, value);
    return true;
}

} // namespace hachure
