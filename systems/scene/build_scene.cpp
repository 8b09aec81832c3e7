#include <hachure/components/name.h>
#include <hachure/components/scene.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/scene/build_scene.h>
#include <hachure/systems/scene/scene_names.h>

#include <fmt/format.h>

#include <optional>
#include <unordered_map>

namespace hachure {
namespace {

using nlohmann::json;

class SceneBuilder {
public:
    SceneBuilder(World& world, SceneCache& cache, const SceneTypes& types, SceneFaults& faults, BuiltScene& built)
        : world_(world), cache_(cache), types_(types), faults_(faults), result_(built) {}

    void run(std::shared_ptr<const SceneFile> file) {
        result_.scopes.push_back({std::move(file), Entity::null, -1});
        const SceneFile& scene = *result_.scopes[0].file;
        await_list(scene.root(), "entities", "", Entity::null, 0);
        while (!pending_.empty()) {
            const Pending next = std::move(pending_.back());
            pending_.pop_back();
            build(next);
        }
    }

private:
    struct Pending {
        const json* value;
        std::string pointer;
        Entity parent;
        std::uint32_t scope;
    };

    const SceneFile& file_of(const Pending& piece) const { return *result_.scopes[piece.scope].file; }

    void fault(const Pending& piece, const std::string& below, std::string_view text) {
        faults_.fault(file_of(piece), piece.pointer + below, text);
    }

    /// Puts the entities of a list on the stack, the first on top.
    void await_list(const json& object, const char* key, const std::string& pointer, Entity parent,
                    std::uint32_t scope) {
        const auto list = object.find(key);
        if (list == object.end()) return;
        const std::string place = pointer + "/" + key;
        if (!list->is_array())
            return faults_.fault(*result_.scopes[scope].file, place, fmt::format("the {} are a list", key));
        for (std::size_t i = list->size(); i-- > 0;)
            pending_.push_back({&(*list)[i], fmt::format("{}/{}", place, i), parent, scope});
    }

    void build(const Pending& piece) {
        if (!piece.value->is_object()) return fault(piece, "", "an entity is an object");
        if (world_.size() >= max_scene_entities)
            throw Error(file_of(piece).text().subject(),
                        fmt::format("has more than {} entities, with all that it refers to", max_scene_entities),
                        file_of(piece).where(piece.pointer));
        const Entity parent = parent_of(piece);
        const std::optional<Entity> made = make(piece);
        if (!made) return;
        const Entity entity = *made;
        if (parent)
            world_.set_parent(entity, parent);
        else
            result_.roots.push_back(entity);
        if (piece.scope > 0) world_.add(entity, Unsaved{});
        result_.pieces.push_back({entity, piece.value, piece.pointer, piece.scope});
        await_list(*piece.value, "children", piece.pointer, entity, piece.scope);
        if (inner_) {
            result_.scopes.push_back({std::move(inner_), entity, static_cast<int>(piece.scope)});
            const auto scope = static_cast<std::uint32_t>(result_.scopes.size() - 1);
            await_list(result_.scopes.back().file->root(), "entities", "", entity, scope);
        }
    }

    /// The entity with its name and its model; nothing where it can't be made. `inner_` is the scene below it then.
    std::optional<Entity> make(const Pending& piece) {
        const json& value = *piece.value;
        inner_ = nullptr;
        const bool has_scene = value.contains("scene");
        if (value.contains("model") && has_scene) {
            fault(piece, "/scene", "an entity has a model or a scene, not both");
            return {};
        }
        Entity entity;
        if (value.contains("model") || has_scene) {
            const std::optional<Entity> referring = make_reference(piece, has_scene);
            if (!referring) return {};
            entity = *referring;
        }
        const auto name = value.find("name");
        const bool named = name != value.end() && name->is_string();
        if (!entity && named) return world_.create_with(Name{name->get<std::string>()}, Transform{});
        if (!entity) return world_.create_with(Transform{});
        if (named) world_.add(entity, Name{name->get<std::string>()});
        return entity;
    }

    std::optional<Entity> make_reference(const Pending& piece, bool is_scene) {
        const std::string key = is_scene ? "scene" : "model";
        const json& said = piece.value->at(key);
        if (!said.is_string() || said == "" || said.get_ref<const std::string&>().find('\0') != std::string::npos) {
            fault(piece, "/" + key, "a " + key + " is the path of a file");
            return {};
        }
        const std::filesystem::path file = file_of(piece).resolve(said.get_ref<const std::string&>());
        Entity entity;
        try {
            entity = is_scene ? make_scene_root(piece, file) : cache_.spawn_copy(world_, file);
        } catch (const Error& error) {
            fault(piece, "/" + key, error.what());
            return {};
        }
        if (!is_scene) result_.models.emplace_back(entity, file);
        const Name* name = world_.find<Name>(entity);
        world_.add(entity, SceneReference{file, is_scene, name ? name->text : "", overrides_of(piece)});
        return entity;
    }

    Entity make_scene_root(const Pending& piece, const std::filesystem::path& file) {
        const std::string path = canonical_path(file);
        int depth = 1;
        for (int at = static_cast<int>(piece.scope); at >= 0; at = result_.scopes[static_cast<std::size_t>(at)].outer) {
            const std::filesystem::path& outer = result_.scopes[static_cast<std::size_t>(at)].file->file();
            if (canonical_path(outer) == path) throw Error(file.string(), "is a scene that contains itself");
            if (++depth > max_scene_depth) throw Error(file.string(), "stands too deep: scenes within scenes");
        }
        inner_ = cache_.scene(file);
        return world_.create_with(Name{file.stem().stem().string()}, Transform{});
    }

    json overrides_of(const Pending& piece) const {
        const auto found = piece.value->find("overrides");
        if (found == piece.value->end() || !found->is_object()) return json::object();
        json result = *found;
        for (auto& [path, components] : result.items())
            components = with_paths(types_, std::move(components), [&](const std::string& path_said) {
                return file_of(piece).resolve(path_said).string();
            });
        return result;
    }

    Entity parent_of(const Pending& piece) {
        const auto below = piece.value->find("below");
        return below == piece.value->end() ? piece.parent : part(piece, *below);
    }

    /// The part of the parent's model or scene that the entity stands below.
    Entity part(const Pending& piece, const json& below) {
        if (!below.is_string() || !piece.parent) {
            fault(piece, "/below", "'below' is the path of names of a part of the model or scene around it");
            return piece.parent;
        }
        const auto [names, fresh] = parts_.try_emplace(piece.parent);
        if (fresh) names->second.emplace(world_, piece.parent);
        const Entity found = names->second->find(world_, below.get_ref<const std::string&>());
        if (!found) fault(piece, "/below", "nothing below the entity around it is called so");
        return found ? found : piece.parent;
    }

    World& world_;
    SceneCache& cache_;
    const SceneTypes& types_;
    SceneFaults& faults_;
    BuiltScene& result_;
    std::vector<Pending> pending_;
    std::shared_ptr<const SceneFile> inner_;
    std::unordered_map<Entity, std::optional<NamesBelow>> parts_;
};

} // namespace

void build_scene(World& world, SceneCache& cache, const SceneTypes& types, std::shared_ptr<const SceneFile> file,
                 SceneFaults& faults, BuiltScene& built) {
    SceneBuilder(world, cache, types, faults, built).run(std::move(file));
}

} // namespace hachure
