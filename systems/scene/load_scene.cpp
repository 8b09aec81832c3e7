#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/scene.h>
#include <hachure/runtime/assets/json_place.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/scene/dress_scene.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/scene_points.h>
#include <hachure/systems/scene/scene_spawner.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;

class SceneLoader {
public:
    SceneLoader(App& app, SceneFaults& faults) : app_(app), types_(app.types()), faults_(faults) {}

    LoadedScene run(const std::filesystem::path& path, const SceneOptions& options) {
        const auto file = cache_.scene(path);
        read_document(*file);
        const std::optional<Style> style = read_style(*file, options);
        World& world = app_.world();
        LoadedScene result;
        try {
            build_scene(world, cache_, types_, file, faults_, built_);
            dress_scene(world, types_, built_, style ? &*style : nullptr, faults_);
            look_around(result);
        } catch (...) {
            world.destroy_many(built_.roots);
            cache_.finish(world);
            throw;
        }
        tell_models();
        cache_.finish(world);
        cache_.forget_scene(path);
        world.set_resource(std::move(document_));
        set_scene_spawner(app_, path, style, std::move(cache_));
        result.roots = std::move(built_.roots);
        result.warnings = faults_.warnings();
        return result;
    }

private:
    /// What the file says of the whole.
    void read_document(const SceneFile& file) {
        document_.file = file.file();
        for (const auto& [key, value] : file.root().items()) {
            if (key == "doc" && value.is_string())
                document_.doc = value.get<std::string>();
            else if (key == "doc")
                faults_.fault(file, "/doc", "the doc of a scene is a text");
            else if (key == "looks")
                read_looks(file, value);
            else if (key == "$schema")
                document_.unknown[key] = value; // for the author's text editor
            else if (key != "hachure_scene" && key != "style" && key != "entities")
                keep_unknown(file, key, value);
        }
    }

    void read_looks(const SceneFile& file, const json& looks) {
        if (!looks.is_object()) return; // whoever uses them says so
        for (const auto& [name, components] : looks.items())
            document_.looks[name] =
                with_paths(types_, components, [&](const std::string& said) { return file.resolve(said).string(); });
    }

    void keep_unknown(const SceneFile& file, const std::string& key, const json& value) {
        faults_.warn(file, "/" + assets::pointer_token(key), "a scene has no '" + key.substr(0, 60) + "'");
        document_.unknown[key] = value;
    }

    std::optional<Style> read_style(const SceneFile& file, const SceneOptions& options) {
        if (const auto said = file.root().find("style"); said != file.root().end()) {
            if (said->is_string())
                document_.style = said->get<std::string>();
            else
                faults_.fault(file, "/style", "the style of a scene is a text");
        }
        if (std::filesystem::path(document_.style).extension() == ".json")
            document_.style = file.resolve(document_.style).string();
        const bool own = options.style.empty() && !document_.style.empty();
        document_.applied_style = own ? document_.style : options.style;
        if (document_.applied_style.empty()) document_.applied_style = options.fallback_style;
        if (document_.applied_style.empty()) return {};
        try {
            return find_style(app_.types(), document_.applied_style);
        } catch (const Error& error) {
            if (!own) throw;
            faults_.fault(file, "/style", error.what());
            return {};
        }
    }

    void look_around(LoadedScene& result) {
        const World& world = app_.world();
        const auto look = [&](Entity entity) {
            const Camera* camera = world.find<Camera>(entity);
            result.has_camera = result.has_camera || (camera && camera->active);
            result.has_light = result.has_light || world.has<Light>(entity);
        };
        for (const Entity root : built_.roots) {
            look(root);
            world.for_each_descendant(root, look);
        }
        if (!result.has_camera) result.points = scene_points(world, cache_, built_);
    }

    void tell_models() {
        std::set<std::string> told;
        for (const auto& [entity, file] : built_.models) {
            if (!told.insert(canonical_path(file)).second) continue;
            for (const std::string& warning : cache_.model(file).warnings) faults_.warn(warning);
        }
    }

    App& app_;
    SceneTypes types_;
    SceneFaults& faults_;
    SceneCache cache_;
    SceneDocument document_;
    BuiltScene built_;
};

} // namespace

LoadedScene load_scene(App& app, const std::filesystem::path& file, const SceneOptions& options) {
    SceneFaults faults(SceneFaults::At::first_throws);
    return SceneLoader(app, faults).run(file, options);
}

SceneFindings inspect_scene(App& app, const std::filesystem::path& file) {
    SceneFaults faults(SceneFaults::At::all_are_kept);
    try {
        static_cast<void>(SceneLoader(app, faults).run(file, {}));
    } catch (const Error& error) {
        faults.fault(error.what());
    }
    return {faults.faults(), faults.warnings()};
}

} // namespace hachure
