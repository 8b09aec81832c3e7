#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/name.h>
#include <hachure/components/picture.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/assets/text_file.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>
#include <hachure/systems/model/model_extras.h>
#include <hachure/systems/styles/style.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;

/// What means something on a picture, by name: styles work without these capabilities, too.
constexpr std::array<std::string_view, 2> on_pictures{"abstracted_lines", "picture_coat"};

constexpr std::size_t max_style_bytes = std::size_t{1} << 20;

/// Hands every fault of a style on, with its place; what it is handed to may throw.
class StyleReader {
public:
    using Report = std::function<void(const Error&)>;

    StyleReader(const TypeRegistry& types, const assets::JsonText& text, Report report)
        : types_(types), text_(text), report_(std::move(report)) {}

    Style read() {
        const json& document = text_.root();
        Style style;
        if (!document.is_object() || !document.contains("hachure_style")) {
            report_(Error(text_.subject(), "is not a style: it lacks \"hachure_style\""));
            return style;
        }
        if (document["hachure_style"] != 1) fault("/hachure_style", "has a version that is not known");
        for (const auto& [key, value] : document.items())
            if (!is_known(key)) fault("/" + key, "a style has no '" + key + "'");
        style.name = document.value("name", json("")).is_string() ? document.value("name", "") : "";
        style.doc = document.value("doc", json("")).is_string() ? document.value("doc", "") : "";
        style.surface = components(document, "surface");
        style.picture = components(document, "picture");
        for (const StyleComponent& component : style.surface)
            if (std::ranges::find(on_pictures, component.type->name) != on_pictures.end() &&
                std::ranges::find(style.picture, component.type, &StyleComponent::type) == style.picture.end())
                style.picture.push_back(component);
        style.camera = components(document, "camera");
        style.light = components(document, "light");
        style.parts = parts(document);
        return style;
    }

private:
    static bool is_known(std::string_view key) {
        constexpr std::array<std::string_view, 8> keys{"camera", "doc",   "hachure_style", "light",
                                                       "name",   "parts", "picture",       "surface"};
        return std::ranges::find(keys, key) != keys.end();
    }

    void fault(const std::string& pointer, const std::string& text) {
        report_(Error(text_.subject(), text, text_.where(pointer)));
    }

    std::vector<StyleComponent> components(const json& style, const char* kind) {
        const auto found = style.find(kind);
        if (found == style.end()) return {};
        return components_in(*found, std::string("/") + kind);
    }

    std::vector<StyleComponent> components_in(const json& said, const std::string& pointer) {
        std::vector<StyleComponent> result;
        if (!said.is_object()) {
            fault(pointer, "the components of a style are an object");
            return result;
        }
        for (const auto& [name, fields] : said.items()) {
            const TypeInfo* type = types_.find(name);
            if (!type)
                fault(pointer + "/" + name, "there is no component '" + name.substr(0, 60) + "'");
            else
                result.push_back({type, fields_of(*type, fields, pointer + "/" + name)});
        }
        return result;
    }

    std::vector<StylePart> parts(const json& style) {
        std::vector<StylePart> result;
        const auto found = style.find("parts");
        if (found == style.end()) return result;
        if (!found->is_array()) {
            fault("/parts", "the parts of a style are an array of entities");
            return result;
        }
        for (std::size_t i = 0; i < found->size(); ++i) {
            json part = (*found)[i];
            const std::string pointer = "/parts/" + std::to_string(i);
            StylePart& made = result.emplace_back();
            made.name = "part " + std::to_string(i + 1);
            if (part.is_object() && part.contains("name")) {
                if (part["name"].is_string())
                    made.name = part["name"].get<std::string>();
                else
                    fault(pointer + "/name", "the name of a part is a text");
                part.erase("name");
            }
            made.components = components_in(part, pointer);
        }
        return result;
    }

    /// One field at a time, so that the fault of one does not hide that of another.
    FieldValues fields_of(const TypeInfo& type, const json& fields, const std::string& pointer) {
        FieldValues result;
        const JsonPlace place{text_.subject(), pointer, [this](std::string_view at) { return text_.where(at); }};
        const auto read_some = [&](const json& some) {
            try {
                FieldValues read = fields_from_json(type, some, place);
                for (auto& [field, value] : read) find_file(*field, value, pointer);
                result.insert(result.end(), read.begin(), read.end());
            } catch (const Error& error) {
                report_(error);
            }
        };
        if (!fields.is_object())
            read_some(fields);
        else
            for (const auto& [name, value] : fields.items()) read_some({{name, value}});
        return result;
    }

    /// Paths of files are relative to the folder of the style's.
    void find_file(const FieldInfo& field, FieldValue& value, const std::string& pointer) {
        auto* path = std::get_if<std::string>(&value);
        if (!path || path->empty() || !is_file_field(field)) return;
        *path = (std::filesystem::path(text_.subject()).parent_path() / *path).lexically_normal().string();
        if (const std::string wrong = file_fault(field, *path); !wrong.empty())
            fault(pointer + "/" + field.name, wrong);
    }

    const TypeRegistry& types_;
    const assets::JsonText& text_;
    Report report_;
};

/// A component of the type with all its fields at their defaults. One that is there keeps what no field holds, as the
/// mesh of a surface.
void* reset_component(World& world, const TypeInfo& type, Entity entity) {
    void* component = type.find_mutable(world, entity);
    if (!component) return type.add_default(world, entity);
    for (const FieldInfo& field : type.fields) field.set(component, field.default_value);
    return component;
}

void add_components(World& world, Entity entity, std::span<const StyleComponent> components) {
    for (const StyleComponent& component : components) {
        void* value = reset_component(world, *component.type, entity);
        for (const auto& [field, field_value] : component.fields) field->set(value, field_value);
    }
    apply_model_extras(world, entity);
}

/// On entities that a style put below a camera.
struct OfStyle {
    static constexpr auto storage = Storage::sparse;
};

/// What a camera carries, and what the view has besides, instead of what another style put there.
void dress_camera(World& world, Entity camera, const Style& style) {
    add_components(world, camera, style.camera);
    std::vector<Entity> old;
    for (const Entity child : world.children(camera))
        if (world.has<OfStyle>(child)) old.push_back(child);
    for (const Entity entity : old) world.destroy(entity);
    for (const StylePart& part : style.parts) {
        const Entity entity = world.create_with(Name{part.name});
        world.add(entity, OfStyle{});
        world.add(entity, Unsaved{});
        world.set_parent(entity, camera);
        add_components(world, entity, part.components);
    }
}

template <class C> std::vector<Entity> entities_with(const World& world) {
    std::vector<Entity> result;
    world.query<With<C>>().each([&result](Entity entity) { result.push_back(entity); });
    return result;
}

std::string known_names() {
    std::string names;
    for (const BuiltInStyle& style : built_in_styles()) names += (names.empty() ? "" : ", ") + std::string(style.name);
    return names;
}

} // namespace

Style parse_style(const TypeRegistry& types, std::string_view subject, std::string_view text) {
    const auto document = assets::JsonText::parse(std::string(subject), std::string(text));
    return StyleReader(types, document, [](const Error& error) { throw Error(error); }).read();
}

std::vector<std::string> style_faults(const TypeRegistry& types, const assets::JsonText& document) {
    std::vector<std::string> result;
    static_cast<void>(
        StyleReader(types, document, [&](const Error& error) { result.emplace_back(error.what()); }).read());
    return result;
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
    if (const TypeInfo* pictures = types.find("picture"))
        for (const Entity entity : pictures->entities(world)) add_components(world, entity, style.picture);
    for (const Entity entity : types.find("camera")->entities(world)) dress_camera(world, entity, style);
    for (const Entity entity : entities_with<DefaultLight>(world)) add_components(world, entity, style.light);
}

void apply_style(World& world, const Style& style, Entity root) {
    std::vector<Entity> cameras;
    const auto apply = [&](Entity entity) {
        if (world.has<Surface>(entity)) add_components(world, entity, style.surface);
        if (world.has<Picture>(entity)) add_components(world, entity, style.picture);
        if (world.has<Camera>(entity)) cameras.push_back(entity);
        if (world.has<DefaultLight>(entity)) add_components(world, entity, style.light);
    };
    apply(root);
    world.for_each_descendant(root, apply);
    for (const Entity camera : cameras) dress_camera(world, camera, style);
}

} // namespace hachure
