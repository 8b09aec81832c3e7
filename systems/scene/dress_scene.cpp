#include <hachure/components/camera.h>
#include <hachure/components/name.h>
#include <hachure/components/picture.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/assets/json_place.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/scene/dress_scene.h>
#include <hachure/systems/scene/scene_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ranges>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;
using Looks = std::map<std::string, std::vector<SaidComponent>, std::less<>>;

/// Keys of an entity that are neither components nor parts.
bool is_structure(std::string_view key) {
    constexpr std::array<std::string_view, 6> keys{"below", "children", "look", "model", "overrides", "scene"};
    return std::ranges::find(keys, key) != keys.end();
}

class SceneDresser {
public:
    SceneDresser(World& world, const SceneTypes& types, const BuiltScene& scene, SceneFaults& faults)
        : world_(world), types_(types), scene_(scene), faults_(faults), parts_(world.find_resource<SceneParts>()) {}

    void run(const Style* style) {
        make_cameras();
        make_pictures();
        if (style)
            for (const Entity root : scene_.roots) apply_style(world_, *style, root);
        for (const ScenePiece& piece : scene_.pieces) give_look(piece);
        for (const ScenePiece& piece : scene_.pieces) give_components(piece);
        for (const ScenePiece& piece : scene_.pieces | std::views::reverse) override_parts(piece);
        name_entities();
        for (const auto& [piece, part] : pending_parts_) read_part(*piece, *part);
    }

private:
    struct PendingEntity {
        Entity entity;
        const TypeInfo* type;
        NamedEntity said;
        std::uint32_t scope;
    };

    const SceneFile& file_of(const ScenePiece& piece) const { return *scene_.scopes[piece.scope].file; }

    /// Styles look for cameras. Where the scene itself has one, those of models and inner scenes rest.
    void make_cameras() {
        bool own = false;
        std::vector<Entity> cameras;
        for (const ScenePiece& piece : scene_.pieces) {
            const auto camera = piece.value->find("camera");
            if (camera == piece.value->end() || camera->is_null() || world_.has<Camera>(piece.entity)) continue;
            cameras.push_back(piece.entity);
            own = own || piece.scope == 0;
        }
        if (own)
            for (const Entity root : scene_.roots)
                world_.for_each_descendant(root, [&](Entity entity) {
                    if (world_.has<Camera>(entity)) world_.get_mutable<Camera>(entity).active = false;
                });
        for (const Entity entity : cameras) world_.add(entity, Camera{.active = !own || !world_.has<Unsaved>(entity)});
    }

    /// Styles look for pictures, too.
    void make_pictures() {
        for (const ScenePiece& piece : scene_.pieces) {
            const auto picture = piece.value->find("picture");
            if (picture != piece.value->end() && !picture->is_null() && !world_.has<Picture>(piece.entity))
                world_.add(piece.entity, Picture{});
        }
    }

    /// The looks of a file, all of them read once.
    const Looks& looks_of(const SceneFile& file) {
        const auto [entry, fresh] = looks_.try_emplace(&file);
        if (!fresh) return entry->second;
        const auto looks = file.root().find("looks");
        if (looks == file.root().end()) return entry->second;
        if (!looks->is_object()) {
            faults_.fault(file, "/looks", "the looks of a scene are an object: sets of components by name");
            return entry->second;
        }
        for (const auto& [name, components] : looks->items())
            entry->second.emplace(
                name, read_components(types_, components, file, "/looks/" + assets::pointer_token(name), faults_));
        return entry->second;
    }

    void give_look(const ScenePiece& piece) {
        const Looks& looks = looks_of(file_of(piece));
        const auto look = piece.value->find("look");
        if (look == piece.value->end()) return;
        const auto found = look->is_string() ? looks.find(look->get_ref<const std::string&>()) : looks.end();
        if (found == looks.end())
            return faults_.fault(file_of(piece), piece.pointer + "/look", "the scene has no such look");
        if (piece.scope == 0) extras(piece.entity).look = look->get<std::string>();
        std::vector<Entity> surfaces;
        const auto take = [&](Entity entity) {
            if (world_.has<Surface>(entity)) surfaces.push_back(entity);
        };
        take(piece.entity);
        world_.for_each_descendant(piece.entity, take);
        for (const Entity surface : surfaces)
            for (const SaidComponent& said : found->second) give(surface, said, piece, "/look");
    }

    void give_components(const ScenePiece& piece) {
        for (const auto& [key, value] : piece.value->items()) {
            if (is_structure(key) || (key == "name" && value.is_string())) continue; // the builder did it
            // A part first: it may stand in the place of the component of its name.
            if (const ScenePart* part = parts_ ? parts_->find(key) : nullptr) {
                pending_parts_.emplace_back(&piece, part);
            } else if (const TypeInfo* type = types_.find(key)) {
                json unknown = json::object();
                if (read_component(*type, value, file_of(piece), piece.pointer + "/" + key, faults_, said_, &unknown))
                    give(piece.entity, said_, piece, "/" + key);
                if (!unknown.empty() && piece.scope == 0) extras(piece.entity).unknown.update(unknown);
            } else {
                faults_.warn(file_of(piece), piece.pointer + "/" + assets::pointer_token(key),
                             "there is no component '" + key.substr(0, 60) + "'");
                if (piece.scope == 0) extras(piece.entity).unknown[key] = value;
            }
        }
    }

    void override_parts(const ScenePiece& piece) {
        const auto overrides = piece.value->find("overrides");
        if (overrides == piece.value->end()) return;
        if (!overrides->is_object() || !world_.has<SceneReference>(piece.entity))
            return faults_.fault(file_of(piece), piece.pointer + "/overrides",
                                 "overrides are an object, by paths of names below an entity with a model or a scene");
        const NamesBelow names(world_, piece.entity);
        std::vector<Entity> parts; // all before any is changed: an override may rename
        for (const auto& [path, components] : overrides->items()) parts.push_back(names.find(world_, path));
        auto part = parts.begin();
        for (const auto& [path, components] : overrides->items()) override_part(piece, path, components, *part++);
    }

    void override_part(const ScenePiece& piece, const std::string& path, const json& components, Entity part) {
        const std::string place = "/overrides/" + assets::pointer_token(path);
        if (!part)
            return faults_.fault(file_of(piece), piece.pointer + place,
                                 "nothing below the entity is called '" + path.substr(0, 60) + "'");
        for (const SaidComponent& said :
             read_components(types_, components, file_of(piece), piece.pointer + place, faults_))
            give(part, said, piece, place + "/" + said.type->name);
    }

    void give(Entity entity, const SaidComponent& said, const ScenePiece& piece, const std::string& place) {
        if (!apply(world_, entity, said))
            return faults_.fault(file_of(piece), piece.pointer + place,
                                 said.type->name + ": only a model gives an entity a surface");
        for (const NamedEntity& named : said.entities)
            pending_entities_.push_back({entity, said.type, named, piece.scope});
    }

    void name_entities() {
        if (pending_entities_.empty()) return;
        NameIndex index;
        index.update(world_);
        std::map<std::pair<std::uint32_t, std::string>, Entity> known;
        for (const PendingEntity& pending : pending_entities_) {
            const SceneScope& scope = scene_.scopes[pending.scope];
            const auto [found, fresh] = known.try_emplace({pending.scope, pending.said.path});
            if (fresh) found->second = find_within(index, world_, pending.said.path, scope.root);
            void* component = pending.type->find_mutable(world_, pending.entity);
            if (!found->second)
                faults_.fault(*scope.file, pending.said.pointer,
                              fmt::format("{}: no entity is called '{}'", pending.said.field->path,
                                          pending.said.path.substr(0, 60)));
            else if (component)
                pending.said.field->set(component, found->second);
        }
    }

    void read_part(const ScenePiece& piece, const ScenePart& part) {
        const SceneFile& file = file_of(piece);
        const std::string pointer = piece.pointer + "/" + part.name;
        std::vector<std::string> warnings;
        const ScenePartSource source{file.text(),
                                     file.pointer_in_text(pointer),
                                     piece.value->at(part.name),
                                     types_.registry(),
                                     file.resolve("."),
                                     warnings};
        try {
            part.read(world_, piece.entity, source);
        } catch (const Error& error) {
            faults_.fault(error.what());
        }
        for (std::string& warning : warnings) faults_.warn(std::move(warning));
    }

    SceneExtras& extras(Entity entity) {
        if (!world_.has<SceneExtras>(entity)) world_.add(entity, SceneExtras{});
        return world_.get_mutable<SceneExtras>(entity);
    }

    World& world_;
    const SceneTypes& types_;
    const BuiltScene& scene_;
    SceneFaults& faults_;
    const SceneParts* parts_;
    std::map<const SceneFile*, Looks> looks_;
    std::vector<PendingEntity> pending_entities_;
    std::vector<std::pair<const ScenePiece*, const ScenePart*>> pending_parts_;
    SaidComponent said_; ///< kept for its memory
};

} // namespace

void dress_scene(World& world, const SceneTypes& types, const BuiltScene& scene, const Style* style,
                 SceneFaults& faults) {
    SceneDresser(world, types, scene, faults).run(style);
}

} // namespace hachure
