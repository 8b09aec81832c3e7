#include <hachure/components/camera.h>
#include <hachure/components/name.h>
#include <hachure/components/picture.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/scene/save_scene.h>
#include <hachure/systems/scene/scene_fields.h>
#include <hachure/systems/scene/scene_paths.h>
#include <hachure/systems/scene/scene_text.h>
#include <hachure/systems/styles/style.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

/// Of entities: each is two levels of JSON, of which a document may have so many.
constexpr int max_depth = static_cast<int>(assets::JsonText::max_depth) / 2;

std::size_t depth_of(const Json& value) {
    std::size_t inner = 0;
    if (value.is_object() || value.is_array())
        for (const Json& element : value) inner = std::max(inner, depth_of(element));
    return inner + (value.is_object() || value.is_array() ? 1 : 0);
}

class SceneSaver {
public:
    SceneSaver(const World& world, const TypeRegistry& registry, const std::filesystem::path& folder,
               std::vector<std::string>* warnings)
        : world_(world), types_(registry), paths_(world, folder), warnings_(warnings),
          parts_(world.find_resource<SceneParts>()) {
        for (const TypeInfo& type : registry.types()) sorted_.push_back(&type);
        std::ranges::sort(sorted_, {}, &TypeInfo::name);
        // Where an entity stands comes first.
        const auto transform = std::ranges::find(sorted_, "transform", &TypeInfo::name);
        if (transform != sorted_.end()) std::rotate(sorted_.begin(), transform, transform + 1);
        if (const SceneDocument* document = world.find_resource<SceneDocument>()) document_ = *document;
        read_style(registry);
    }

    Json run() {
        Json result;
        result["hachure_scene"] = 1;
        if (!document_.doc.empty()) result["doc"] = document_.doc;
        if (!document_.style.empty())
            result["style"] = std::filesystem::path(document_.style).extension() == ".json"
                                  ? paths_.relative(document_.style)
                                  : document_.style;
        for (const auto& [key, value] : document_.unknown.items()) result[key] = value;
        if (!document_.looks.empty()) {
            Json& looks = result["looks"] = Json::object();
            for (const auto& [name, components] : document_.looks.items())
                looks[name] =
                    with_paths(types_, components, [&](const std::string& path) { return paths_.relative(path); });
        }
        Json& entities = result["entities"] = Json::array();
        for (const Entity root : roots())
            if (is_told(root)) entities.push_back(entity(root, 0));
        return result;
    }

private:
    /// Without its style, which may be lost by now, a scene is written all the same: with what the style gave.
    void read_style(const TypeRegistry& registry) {
        if (document_.applied_style.empty()) return;
        try {
            style_ = find_style(registry, document_.applied_style);
        } catch (const Error& error) {
            if (warnings_) warnings_->emplace_back(error.what());
        }
    }

    std::vector<Entity> roots() const {
        std::vector<Entity> result;
        world_.query<Without<Parent>>().each([&](Entity entity) { result.push_back(entity); });
        std::ranges::sort(result);
        return result;
    }

    /// Entities that say nothing to anybody, as helpers of a program do, are not written.
    bool is_told(Entity root) const {
        return !world_.has<Unsaved>(root) && (world_.has<SceneReference>(root) || !world_.children(root).empty() ||
                                              std::ranges::any_of(sorted_, [&](const TypeInfo* type) {
                                                  return type->find(world_, root) != nullptr;
                                              }));
    }

    Json entity(Entity entity, int depth) {
        if (depth > max_depth) throw Error("scene", "entities stand too deep below each other for a file");
        const auto* reference = world_.find<SceneReference>(entity);
        const auto* extras = world_.find<SceneExtras>(entity);
        Json result = Json::object();
        write_name(entity, reference, result);
        if (reference) result[reference->is_scene ? "scene" : "model"] = paths_.relative(reference->file);
        if (extras && !extras->look.empty()) result["look"] = extras->look;
        for (const TypeInfo* type : sorted_) write_component(entity, *type, result);
        write_parts(entity, result);
        if (extras)
            for (const auto& [key, value] : extras->unknown.items()) merge(result, key, value);
        if (reference && !reference->overrides.empty()) write_overrides(*reference, result);
        Json children = Json::array();
        write_children(entity, entity, depth, children);
        if (!children.empty()) result["children"] = std::move(children);
        return result;
    }

    void write_name(Entity entity, const SceneReference* reference, Json& result) {
        const Name* name = world_.find<Name>(entity);
        if (name && (!reference || name->text != reference->own_name)) result["name"] = name->text;
        if (!name && reference) result["name"] = nullptr;
    }

    /// What a scene gives an entity without being told.
    std::optional<FieldValues> implied(Entity entity, const TypeInfo& type) const {
        if (type.component == detail::component_id<Transform>()) return FieldValues{};
        if (!style_) return {};
        // The camera's come last, as the style puts them.
        std::optional<FieldValues> result;
        const auto look = [&](const std::vector<StyleComponent>& given) {
            for (const StyleComponent& component : given)
                if (component.type == &type) result = component.fields;
        };
        if (world_.has<Picture>(entity)) look(style_->picture);
        if (world_.has<Camera>(entity)) look(style_->camera);
        return result;
    }

    void write_component(Entity entity, const TypeInfo& type, Json& result) {
        if (type.component == detail::component_id<Name>()) return;
        const void* component = type.find(world_, entity);
        const std::optional<FieldValues> given = implied(entity, type);
        if (!component) {
            if (given) result[type.name] = nullptr;
            return;
        }
        if (type.component == detail::component_id<Surface>()) return warn(entity, "has a surface that no file made");
        Json fields = Json::object();
        for (const FieldInfo& field : type.fields) {
            FieldValue value = field.get(component);
            if (value == (given ? given_value(*given, field) : field.default_value)) continue;
            if (const std::string fault = field.fault(value); !fault.empty())
                throw Error(paths_.label(entity), field.path + ": " + fault);
            fields[field.name] = field_json(entity, field, std::move(value));
        }
        if (!given || !fields.empty()) result[type.name] = std::move(fields);
    }

    static const FieldValue& given_value(const FieldValues& given, const FieldInfo& field) {
        const auto found = std::ranges::find(given, &field, &FieldValues::value_type::first);
        return found != given.end() ? found->second : field.default_value;
    }

    json field_json(Entity owner, const FieldInfo& field, FieldValue value) {
        if (is_file_field(field) && !std::get<std::string>(value).empty())
            return paths_.relative(std::get<std::string>(value));
        if (field.kind != FieldKind::entity) return to_json(field, value);
        const Entity target = std::get<Entity>(value);
        if (!world_.alive(target)) return nullptr;
        const std::optional<std::string> path = paths_.path_to(target);
        if (path) return *path;
        warn(owner, field.path + " refers to an entity that no path of names finds");
        return nullptr;
    }

    void write_parts(Entity entity, Json& result) {
        if (!parts_) return;
        for (const ScenePart& part : parts_->parts)
            if (std::optional<json> value = part.write(world_, entity)) result[part.name] = std::move(*value);
    }

    static void merge(Json& result, const std::string& key, const json& value) {
        if (value.is_object() && result.contains(key) && result[key].is_object())
            for (const auto& [name, field] : value.items()) result[key][name] = field;
        else
            result[key] = value;
    }

    void write_overrides(const SceneReference& reference, Json& result) const {
        Json& overrides = result["overrides"] = Json::object();
        for (const auto& [path, components] : reference.overrides.items())
            overrides[path] =
                with_paths(types_, components, [&](const std::string& file) { return paths_.relative(file); });
    }

    /// The children that a file tells of: those of `at`, and of the parts of a model or scene at and below it.
    void write_children(Entity owner, Entity at, int depth, Json& children) {
        for (const Entity child : world_.children(at)) {
            if (world_.has<Unsaved>(child)) {
                write_children(owner, child, depth, children);
                continue;
            }
            Json written = entity(child, depth + 1);
            if (at != owner) {
                const std::optional<std::string> below = paths_.path_below(owner, at);
                if (below)
                    written["below"] = *below;
                else
                    warn(child, "stands below a part that no path of names finds: it moves to the whole");
            }
            children.push_back(std::move(written));
        }
    }

    void warn(Entity entity, const std::string& what) {
        if (warnings_) warnings_->push_back(paths_.label(entity) + " " + what);
    }

    const World& world_;
    SceneTypes types_;
    ScenePaths paths_;
    std::vector<std::string>* warnings_;
    const SceneParts* parts_;
    std::vector<const TypeInfo*> sorted_;
    SceneDocument document_;
    std::optional<Style> style_;
};

} // namespace

std::string save_scene(const World& world, const TypeRegistry& types, const std::filesystem::path& folder,
                       std::vector<std::string>* warnings) {
    const Json document = SceneSaver(world, types, folder, warnings).run();
    if (depth_of(document) > assets::JsonText::max_depth)
        throw Error("scene", "entities stand too deep below each other for a file");
    return scene_text(document);
}

std::vector<std::string> write_scene(const World& world, const TypeRegistry& types, const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    const std::string text = save_scene(world, types, file.parent_path(), &warnings);
    assets::write_file_atomically(file, std::as_bytes(std::span(text)));
    return warnings;
}

} // namespace hachure
