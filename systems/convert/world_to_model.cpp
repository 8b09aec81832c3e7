#include <hachure/components/light.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/name.h>
#include <hachure/components/rig.h>
#include <hachure/components/scene.h>
#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/assets/append_model.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/convert/camera_light.h>
#include <hachure/systems/convert/entity_extras.h>
#include <hachure/systems/convert/instance_entities.h>
#include <hachure/systems/convert/read_source.h>
#include <hachure/systems/convert/world_to_model.h>

#include <algorithm>
#include <array>
#include <map>
#include <ranges>
#include <set>
#include <unordered_set>
#include <utility>

namespace hachure {
namespace {

using nlohmann::json;

/// Files beyond this are not read again.
constexpr std::size_t most_nodes = 400'000;

class WorldConverter {
public:
    WorldConverter(const App& app, const WorldToModel& what, std::vector<std::string>& warnings)
        : app_(app), world_(app.world()), what_(what), warnings_(warnings), extras_of_(app, what, warnings) {}

    assets::Model run() {
        model_.scenes.push_back({what_.scene.stem().stem().string(), {}, {}});
        const std::filesystem::path folder = what_.scene.parent_path();
        for (const Entity root : what_.roots) model_.scenes[0].roots.push_back(convert(root, -1, folder));
        put_cameras_and_lights();
        put_playing();
        put_style();
        for (std::size_t i = 0; i < extras_.size(); ++i)
            if (!extras_[i].empty()) model_.nodes[i].extras = extras_[i].dump();
        if (!scene_extras_.empty()) model_.scenes[0].extras = scene_extras_.dump();
        return std::move(model_);
    }

private:
    struct Source {
        assets::Model model;
        assets::ModelPlaces shared;
    };

    assets::Node& node(std::int32_t index) { return model_.nodes[static_cast<std::size_t>(index)]; }
    json& extras(std::int32_t index) {
        extras_.resize(model_.nodes.size(), json::object());
        return extras_[static_cast<std::size_t>(index)];
    }

    /// The new node of an entity, with all below it.
    std::int32_t convert(Entity entity, std::int32_t parent, std::filesystem::path folder) {
        check_size(1);
        const auto index = static_cast<std::int32_t>(model_.nodes.size());
        model_.nodes.emplace_back().parent = parent;
        describe(index, entity, entity, folder);
        if (const SceneReference* reference = world_.find<SceneReference>(entity)) {
            if (reference->is_scene)
                folder = reference->file.parent_path();
            else
                put_instance(index, entity, *reference, folder);
        }
        convert_children(index, entity, folder);
        return index;
    }

    void convert_children(std::int32_t index, Entity entity, const std::filesystem::path& folder) {
        for (const Entity child : world_.children(entity)) {
            if (of_models_.contains(child)) continue;
            const std::int32_t below = convert(child, index, folder);
            node(index).children.push_back(below);
        }
    }

    void put_instance(std::int32_t index, Entity root, const SceneReference& reference,
                      const std::filesystem::path& folder) {
        const Source& source = source_of(reference.file);
        check_size(source.model.nodes.size());
        const assets::ModelPlaces places = assets::append_instance(model_, source.model, source.shared, index);
        name_clips(places, node(index).name);
        const InstanceEntities entities = instance_entities(world_, source.model, root);
        of_models_.insert(entities.nodes.begin(), entities.nodes.end());
        of_models_.insert(entities.surfaces.begin(), entities.surfaces.end());
        for (std::size_t i = 0; i < entities.nodes.size(); ++i) {
            if (!entities.nodes[i]) continue;
            const std::int32_t at = places.nodes + static_cast<std::int32_t>(i);
            describe(at, entities.nodes[i], entities.surfaces[i] ? entities.surfaces[i] : entities.nodes[i], folder);
            convert_children(at, entities.nodes[i], folder);
        }
    }

    const Source& source_of(const std::filesystem::path& file) {
        const auto [entry, fresh] = sources_.try_emplace(file.lexically_normal().string());
        Source& source = entry->second;
        if (!fresh) return source;
        source.model = read_source(file);
        source.shared = assets::append_resources(model_, source.model);
        // What they said has come to the entities, which say it now.
        for (assets::Material& material : model_.materials) material.extras.clear();
        return source;
    }

    void name_clips(const assets::ModelPlaces& places, const std::string& owner) {
        for (std::size_t i = static_cast<std::size_t>(places.animations); i < model_.animations.size(); ++i) {
            std::string& name = model_.animations[i].name;
            const std::string own = name;
            for (int number = 1; !name.empty() && !clip_names_.insert(name).second; ++number)
                name = owner + "/" + own + (number > 1 ? " " + std::to_string(number) : "");
        }
    }

    /// Puts what an entity is into its node; `surface` draws the node's mesh, and is often the entity itself.
    void describe(std::int32_t index, Entity entity, Entity surface, const std::filesystem::path& folder) {
        assets::Node& target = node(index);
        if (const Name* name = world_.find<Name>(entity)) target.name = name->text;
        if (const Transform* transform = world_.find<Transform>(entity)) {
            target.translation = transform->translation;
            target.rotation = transform->rotation;
            target.scale = transform->scale;
        }
        target.matrix.reset();
        if (const LocalMatrix* matrix = world_.find<LocalMatrix>(entity)) target.matrix = matrix->matrix;
        if (const MorphWeights* weights = world_.find<MorphWeights>(surface)) target.morph_weights = weights->values;
        if (const Camera* camera = world_.find<Camera>(entity)) cameras_.emplace(index, *camera);
        if (const Light* light = world_.find<Light>(entity)) lights_.emplace(index, *light);
        json said = extras_of_.of(entity, folder);
        if (surface != entity) said.update(extras_of_.of(surface, folder));
        if (world_.has<Rig>(entity)) take_playing(index, said);
        extras(index) = std::move(said);
    }

    /// What only the root of a model can carry once it is read.
    void take_playing(std::int32_t index, json& said) {
        json playing = json::object();
        for (const char* key : {"animation", "animation_events", "animation_layers", "animation_states", "root_motion"})
            if (const auto found = said.find(key); found != said.end()) {
                playing[key] = std::move(*found);
                said.erase(found);
            }
        if (!playing.empty()) playing_.emplace_back(index, std::move(playing));
    }

    void put_playing() {
        if (playing_.size() == 1) return scene_extras_.update(playing_[0].second);
        for (const auto& [index, playing] : playing_) extras(index).update(playing);
        if (playing_.empty()) return;
        warnings_.push_back(std::to_string(playing_.size()) +
                            " models play clips, and a glTF file plays one: what they play stays in the extras of "
                            "their nodes, which stand still");
    }

    void put_style() {
        const SceneDocument* document = world_.find_resource<SceneDocument>();
        if (!document || document->style.empty()) return;
        const bool is_file = std::filesystem::path(document->style).extension() == ".json";
        scene_extras_["style"] = is_file ? extras_of_.relative(document->style) : document->style;
    }

    void put_cameras_and_lights() {
        bool first = true;
        for (const std::int32_t index : in_order()) {
            if (const auto camera = cameras_.find(index); camera != cameras_.end()) {
                std::int32_t& place = node(index).camera;
                put(model_.cameras, place, used_cameras_,
                    [&](const assets::Camera& before) { return gltf_camera(camera->second, before); });
                json said =
                    camera_extras(app_.types(), camera->second, model_.cameras[static_cast<std::size_t>(place)], first);
                if (!said.empty()) extras(index)["camera"] = std::move(said);
                first = false;
            }
            if (const auto light = lights_.find(index); light != lights_.end()) {
                std::int32_t& place = node(index).light;
                put(model_.lights, place, used_lights_,
                    [&](const assets::Light& before) { return gltf_light(light->second, before); });
                json said = light_extras(app_.types(), light->second, model_.lights[static_cast<std::size_t>(place)]);
                if (!said.empty()) extras(index)["light"] = std::move(said);
            }
        }
    }

    /// Changes the thing at `place`, which clips may mean, or one of its own where another node has it already.
    template <class T, class Make>
    static void put(std::vector<T>& list, std::int32_t& place, std::set<std::int32_t>& used, const Make& make) {
        T made = make(place >= 0 ? list[static_cast<std::size_t>(place)] : T{});
        if (place < 0 || used.contains(place)) {
            place = static_cast<std::int32_t>(list.size());
            list.emplace_back();
        }
        list[static_cast<std::size_t>(place)] = std::move(made);
        used.insert(place);
    }

    /// The nodes as readers make entities of them.
    std::vector<std::int32_t> in_order() {
        std::vector<std::int32_t> result, pending(model_.scenes[0].roots.rbegin(), model_.scenes[0].roots.rend());
        while (!pending.empty()) {
            const std::int32_t index = pending.back();
            pending.pop_back();
            result.push_back(index);
            for (const std::int32_t child : node(index).children | std::views::reverse) pending.push_back(child);
        }
        return result;
    }

    void check_size(std::size_t more) const {
        if (model_.nodes.size() + more > most_nodes)
            throw Error(what_.scene.string(),
                        "would become a glTF file of more than " + std::to_string(most_nodes) + " nodes");
    }

    const App& app_;
    const World& world_;
    const WorldToModel& what_;
    std::vector<std::string>& warnings_;
    EntityExtras extras_of_;
    assets::Model model_;
    std::vector<json> extras_; ///< by node
    json scene_extras_ = json::object();
    std::map<std::string, Source> sources_;
    std::set<std::string> clip_names_;
    std::unordered_set<Entity> of_models_;              ///< which are nodes already
    std::map<std::int32_t, Camera> cameras_;            ///< by node
    std::map<std::int32_t, Light> lights_;              ///< by node
    std::set<std::int32_t> used_cameras_, used_lights_; ///< by index into the model
    std::vector<std::pair<std::int32_t, json>> playing_;
};

} // namespace

assets::Model world_to_model(const App& app, const WorldToModel& what, std::vector<std::string>& warnings) {
    return WorldConverter(app, what, warnings).run();
}

} // namespace hachure
