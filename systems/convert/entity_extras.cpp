#include <hachure/components/camera.h>
#include <hachure/components/model_extras.h>
#include <hachure/components/name.h>
#include <hachure/components/picture.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/scene/file_fields.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/convert/entity_extras.h>

#include <algorithm>
#include <array>

namespace hachure {
namespace {

using nlohmann::json;

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

std::filesystem::path canonical_path(const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
}

} // namespace

EntityExtras::EntityExtras(const App& app, const WorldToModel& what, std::vector<std::string>& warnings)
    : world_(app.world()), types_(app.types()), what_(what), warnings_(warnings),
      folder_(canonical_path(what.output).parent_path()) {}

json EntityExtras::of(Entity entity, const std::filesystem::path& folder) const {
    json result = json::object();
    for (const TypeInfo& type : types_.types()) {
        if (is_one_of(type.name, {"transform", "name", "camera", "light"})) continue; // a node's own
        const void* found = type.find(world_, entity);
        if (!found) continue;
        if (json fields = component(entity, type, found); !fields.is_null()) result[type.name] = std::move(fields);
    }
    result.update(parts_of(entity, folder));
    if (const SceneExtras* extras = world_.find<SceneExtras>(entity)) result.update(extras->unknown);
    return result;
}

json EntityExtras::parts_of(Entity entity, const std::filesystem::path& folder) const {
    json result = json::object();
    if (const SceneParts* parts = world_.find_resource<SceneParts>())
        for (const ScenePart& part : parts->parts) {
            std::optional<json> written = part.write(world_, entity);
            if (!written) continue;
            if (written->is_object() && written->contains("file") && (*written)["file"].is_string())
                (*written)["file"] = relative(folder / (*written)["file"].get<std::string>());
            result[part.name] = std::move(*written);
        }
    return result;
}

json EntityExtras::said_by_file(Entity entity) const {
    json result = json::object();
    const ModelExtras* extras = world_.find<ModelExtras>(entity);
    if (!extras) return result;
    for (const auto& [type, fields] : extras->components) {
        json& component = result[type->name];
        if (component.is_null()) component = json::object();
        for (const auto& [field, said] : fields)
            if (json written = value(*field, said); !written.is_null()) component[field->name] = std::move(written);
    }
    return result;
}

json EntityExtras::component(Entity entity, const TypeInfo& type, const void* component) const {
    const StyleComponent* style = styled(entity, type);
    json result = json::object();
    for (const FieldInfo& field : type.fields) {
        FieldValue usual = field.default_value;
        if (style)
            for (const auto& [styled_field, styled_value] : style->fields)
                if (styled_field == &field) usual = styled_value;
        const FieldValue now = field.get(component);
        if (now == usual) continue;
        if (json said = value(field, now); !said.is_null()) result[field.name] = std::move(said);
    }
    // A style gives it, or a mesh.
    if (result.empty() && (style || is_one_of(type.name, {"surface", "deform"}))) return nullptr;
    return result;
}

const StyleComponent* EntityExtras::styled(Entity entity, const TypeInfo& type) const {
    if (!what_.style) return nullptr;
    const auto find = [&](const std::vector<StyleComponent>& list) -> const StyleComponent* {
        const auto found = std::ranges::find(list, &type, &StyleComponent::type);
        return found == list.end() ? nullptr : &*found;
    };
    const StyleComponent* result = world_.has<Surface>(entity) ? find(what_.style->surface) : nullptr;
    if (!result && world_.has<Picture>(entity)) result = find(what_.style->picture);
    return !result && world_.has<Camera>(entity) ? find(what_.style->camera) : result;
}

json EntityExtras::value(const FieldInfo& field, const FieldValue& value) const {
    if (field.kind == FieldKind::entity) {
        std::string path = path_of(std::get<Entity>(value));
        if (!path.empty()) return path;
        warnings_.push_back(field.path + " is left out: it is an entity without a name");
        return nullptr;
    }
    if (is_file_field(field)) return relative(what_.scene.parent_path() / std::get<std::string>(value));
    return to_json(field, value);
}

std::string EntityExtras::relative(const std::filesystem::path& file) const {
    std::string result = canonical_path(file).lexically_relative(folder_).generic_string();
    if (result.starts_with(".."))
        warnings_.push_back("'" + result + "' lies outside the folder of " + what_.output.string() +
                            ": it will not be found from there");
    return result;
}

std::string EntityExtras::path_of(Entity entity) const {
    std::string result;
    for (; entity; entity = world_.parent(entity)) {
        const Name* name = world_.find<Name>(entity);
        if (!name || name->text.empty()) return {};
        result = result.empty() ? name->text : name->text + "/" + result;
    }
    return result;
}

} // namespace hachure
