#include <hachure/components/name.h>
#include <hachure/components/name_index.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/convert/entity_extras.h>
#include <hachure/systems/convert/model_to_scene.h>
#include <hachure/systems/model/spawn_model.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

class SceneWriter {
public:
    SceneWriter(App& app, const std::filesystem::path& model, const std::filesystem::path& output,
                std::vector<std::string>& warnings)
        : app_(app), world_(app.world()), model_(model), warnings_(warnings), what_{{}, nullptr, model, output},
          extras_(app, what_, warnings) {}

    std::string run() {
        const assets::Model model = assets::read_model(model_);
        std::ranges::copy(model.warnings, std::back_inserter(warnings_));
        SpawnedModel spawned = spawn_model(world_, model, &app_.types());
        std::ranges::move(spawned.warnings, std::back_inserter(warnings_));
        root_ = spawned.root;
        name_ = model_.stem().string();
        world_.add(root_, Name{name_});
        names_.update(world_);

        ordered_json scene{{"hachure_scene", 1}};
        if (!spawned.style.empty())
            scene["style"] = std::filesystem::path(spawned.style).extension() == ".json"
                                 ? extras_.relative(spawned.style)
                                 : spawned.style;
        ordered_json entity{{"name", name_}, {"model", extras_.relative(model_)}};
        if (const json look = common_look(spawned.surfaces); !look.empty()) {
            scene["looks"][name_] = look;
            entity["look"] = name_;
            looked_at_ = spawned.surfaces;
        }
        const json own = said(root_);
        for (const auto& [name, value] : own.items()) entity[name] = value;
        world_.for_each_descendant(root_, [&](Entity part) { put_override(entity, part); });
        scene["entities"] = ordered_json::array({std::move(entity)});
        return scene.dump(2) + "\n";
    }

private:
    json said(Entity entity) const {
        json result = extras_.said_by_file(entity);
        result.update(extras_.parts_of(entity, model_.parent_path()));
        return result;
    }

    /// What all of them say; nothing where they differ.
    json common_look(const std::vector<Entity>& surfaces) const {
        json result;
        for (const Entity surface : surfaces) {
            json own = said(surface);
            if (result.is_null())
                result = std::move(own);
            else if (result != own)
                return {};
        }
        return result;
    }

    void put_override(ordered_json& entity, Entity part) {
        if (std::ranges::find(looked_at_, part) != looked_at_.end()) return;
        const json components = said(part);
        if (components.empty()) return;
        const std::string path = extras_.path_of(part).substr(name_.size() + 1);
        const std::vector<Entity> found = names_.find_all(world_, path);
        if (!found.empty() && found.front() == part) {
            entity["overrides"][path] = components;
            return;
        }
        warnings_.push_back("several things are called '" + path.substr(0, 100) +
                            "': what the file says of one of them stays in the model alone");
    }

    App& app_;
    World& world_;
    const std::filesystem::path& model_;
    std::vector<std::string>& warnings_;
    WorldToModel what_;
    EntityExtras extras_;
    NameIndex names_;
    Entity root_;
    std::string name_;
    std::vector<Entity> looked_at_; ///< whose extras the look says
};

} // namespace

std::string model_to_scene(App& app, const std::filesystem::path& model, const std::filesystem::path& output,
                           std::vector<std::string>& warnings) {
    return SceneWriter(app, model, output, warnings).run();
}

} // namespace hachure
