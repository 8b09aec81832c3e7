#include <hachure/components/surface.h>
#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/model/extra_fields.h>
#include <hachure/systems/model/model_extras.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;

/// A speaker of the file.
struct Speaker {
    std::string name;    ///< for people: "node 'Fox'"
    std::string pointer; ///< of its extras in the file
};

std::string called(const char* kind, const std::string& name, std::size_t index) {
    return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("{} '{}'", kind, name.substr(0, 60));
}

/// What is the node's own even where its mesh is drawn by another entity.
bool stays_with_node(std::string_view component) {
    static constexpr std::array<std::string_view, 4> own{"transform", "name", "camera", "light"};
    return std::ranges::find(own, component) != own.end();
}

class ExtrasReader {
public:
    ExtrasReader(World& world, const TypeRegistry& types, const assets::Model& model, const ModelEntities& entities)
        : world_(world), types_(types), model_(model), entities_(entities),
          fields_(world, entities.root, model.file, result_.warnings) {}

    FileExtras run() {
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            if (entities_.surfaces[i]) read_materials(i);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            if (entities_.nodes[i]) read_node(i);
        const auto scene = static_cast<std::size_t>(model_.default_scene);
        const Speaker speaker{called("scene", model_.scenes[scene].name, scene),
                              fmt::format("/scenes/{}/extras/hachure", scene)};
        json extras = parsed(model_.scenes[scene].extras);
        if (const auto style = extras.find("style"); style != extras.end()) {
            read_style(*style, speaker);
            extras.erase(style);
        }
        for (const auto& [name, value] : extras.items()) read(speaker, name, value, entities_.root);
        return std::move(result_);
    }

private:
    /// Surfaces have one look: that of the first material that asks for one.
    void read_materials(std::size_t node) {
        const auto& primitives = model_.meshes[static_cast<std::size_t>(model_.nodes[node].mesh)].primitives;
        const assets::Material* first = nullptr;
        bool differs = false;
        for (const assets::Primitive& primitive : primitives) {
            if (primitive.material < 0) continue;
            const assets::Material& material = model_.materials[static_cast<std::size_t>(primitive.material)];
            if (!first && !material.extras.empty()) first = &material;
        }
        if (!first) return;
        for (const assets::Primitive& primitive : primitives)
            differs |= primitive.material < 0 ||
                       model_.materials[static_cast<std::size_t>(primitive.material)].extras != first->extras;
        const auto index = static_cast<std::size_t>(first - model_.materials.data());
        const Speaker speaker{called("material", first->name, index),
                              fmt::format("/materials/{}/extras/hachure", index)};
        if (differs)
            warn(speaker, {},
                 "the materials of " + called("node", model_.nodes[node].name, node) +
                     " say different things; what this one says holds for the whole surface");
        const json extras = parsed(first->extras);
        for (const auto& [name, value] : extras.items()) read(speaker, name, value, entities_.surfaces[node]);
    }

    void read_node(std::size_t node) {
        const Speaker speaker{called("node", model_.nodes[node].name, node),
                              fmt::format("/nodes/{}/extras/hachure", node)};
        const json extras = parsed(model_.nodes[node].extras);
        for (const auto& [name, value] : extras.items()) {
            const bool drawn_elsewhere = entities_.surfaces[node] && !stays_with_node(name);
            read(speaker, name, value, drawn_elsewhere ? entities_.surfaces[node] : entities_.nodes[node]);
        }
    }

    void read(const Speaker& speaker, const std::string& name, const json& value, Entity entity) {
        const std::string pointer = speaker.pointer + "/" + name;
        if (const TypeInfo* type = types_.find(name)) {
            if (name == "surface" && !world_.has<Surface>(entity))
                return warn(speaker, pointer, "nothing is drawn here that a surface could be");
            if (!value.is_object()) return warn(speaker, pointer, "the fields of a component are an object");
            FieldValues values = fields_.read(*type, value, speaker.name, pointer);
            result_.said.push_back({entity, {type, std::move(values)}});
            return;
        }
        const SceneParts* parts = world_.find_resource<SceneParts>();
        const ScenePart* part = parts ? parts->find(name) : nullptr;
        if (!part) return warn(speaker, pointer, "there is no component '" + name.substr(0, 60) + "'");
        read_part(*part, value, entity, speaker, pointer);
    }

    /// Places of faults are then those in the extras alone.
    void read_part(const ScenePart& part, const json& value, Entity entity, const Speaker& speaker,
                   const std::string& pointer) {
        try {
            const assets::JsonText text =
                assets::JsonText::parse(model_.file.string() + ": " + speaker.name, json{{part.name, value}}.dump());
            part.read(world_, entity,
                      {text, "/" + part.name, text.root().at(part.name), types_, model_.file.parent_path(),
                       result_.warnings});
        } catch (const Error& error) {
            warn(speaker, pointer, error.what());
        }
    }

    void read_style(const json& value, const Speaker& speaker) {
        const std::string pointer = speaker.pointer + "/style";
        if (!value.is_string()) return warn(speaker, pointer, "a style is a name or a file");
        result_.style = value.get<std::string>();
        if (!result_.style.ends_with(".json")) return;
        try {
            result_.style = assets::resolve_beside(model_.file, result_.style, pointer).string();
        } catch (const Error& error) {
            result_.style.clear();
            warn(speaker, {}, error.what());
        }
    }

    void warn(const Speaker& speaker, const std::string& pointer, const std::string& fault) {
        result_.warnings.push_back(
            fmt::format("{}: {} ({})", speaker.name, fault, pointer.empty() ? speaker.pointer : pointer));
    }

    static json parsed(const std::string& extras) { return extras.empty() ? json::object() : json::parse(extras); }

    World& world_;
    const TypeRegistry& types_;
    const assets::Model& model_;
    const ModelEntities& entities_;
    FileExtras result_;
    ExtraFields fields_;
};

} // namespace

FileExtras read_model_extras(World& world, const TypeRegistry& types, const assets::Model& model,
                             const ModelEntities& entities) {
    return ExtrasReader(world, types, model, entities).run();
}

void apply_model_extras(World& world, Entity entity) {
    const ModelExtras* extras = world.find<ModelExtras>(entity);
    if (!extras) return;
    const ModelExtras said = *extras; // adding a component moves those that are there
    for (const auto& [type, fields] : said.components) {
        void* component = type->find_mutable(world, entity);
        if (!component) component = type->add_default(world, entity);
        for (const auto& [field, value] : fields) field->set(component, value);
    }
}

} // namespace hachure
