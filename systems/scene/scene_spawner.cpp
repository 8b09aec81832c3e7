#include <hachure/components/name.h>
#include <hachure/components/name_index.h>
#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/systems/scene/dress_scene.h>
#include <hachure/systems/scene/scene_spawner.h>

#include <memory>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;

class SceneSpawner {
public:
    SceneSpawner(const TypeRegistry& types, std::filesystem::path file, std::optional<Style> style, SceneCache cache)
        : types_(types), file_(std::move(file)), style_(std::move(style)), cache_(std::move(cache)) {}

    Entity spawn(World& world, const SpawnRequest& request) {
        if (request.parent && !world.alive(request.parent))
            throw Error("spawning '" + request.what + "'", "the parent is dead");
        const bool is_file = request.what.find('.') != std::string::npos;
        const Entity entity = is_file ? from_file(world, request) : copy(world, request.what);
        if (!request.name.empty()) world.add(entity, Name{request.name});
        if (request.parent) world.set_parent(entity, request.parent);
        return entity;
    }

private:
    Entity copy(World& world, const std::string& name) {
        names_.update(world);
        const Entity original = names_.find(world, name);
        if (!original) throw Error("spawning '" + name + "'", "no entity is called so");
        return world.instantiate(original);
    }

    /// As a scene file with this one entity would make it.
    Entity from_file(World& world, const SpawnRequest& request) {
        const std::filesystem::path file = checked(request.what);
        const json document{{"hachure_scene", scene_version},
                            {"entities", json::array({{{is_scene_name(file) ? "scene" : "model", request.what}}})}};
        SceneFaults faults(SceneFaults::At::first_throws);
        const SceneTypes types(types_);
        BuiltScene built;
        try {
            build_scene(world, cache_, types, std::make_shared<SceneFile>(SceneFile::parse(file_, document.dump())),
                        faults, built);
            dress_scene(world, types, built, style_ ? &*style_ : nullptr, faults);
        } catch (...) {
            world.destroy_many(built.roots);
            cache_.finish(world);
            throw;
        }
        cache_.finish(world);
        return built.roots.front();
    }

    /// The path of a file that lies in the scene's folder or below, and is there.
    std::filesystem::path checked(const std::string& what) const {
        std::string escaped; // path rules are those of URIs
        for (const char c : what) escaped += c == '%' ? "%25" : std::string(1, c);
        std::filesystem::path file = assets::resolve_beside(file_, escaped);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) throw Error(file.string(), "there is no such file");
        return file;
    }

    const TypeRegistry& types_;
    std::filesystem::path file_;
    std::optional<Style> style_;
    SceneCache cache_;
    NameIndex names_;
};

} // namespace

void set_scene_spawner(App& app, const std::filesystem::path& file, std::optional<Style> style, SceneCache cache) {
    const auto state = std::make_shared<SceneSpawner>(app.types(), file, std::move(style), std::move(cache));
    app.world().set_resource(
        Spawner{[state](World& world, const SpawnRequest& request) { return state->spawn(world, request); }});
}

} // namespace hachure
