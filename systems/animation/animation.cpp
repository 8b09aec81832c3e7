#include <hachure/components/animation.h>
#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/name.h>
#include <hachure/components/rig.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/animation/animation_parts.h>
#include <hachure/systems/animation/model_player.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using Models = Query<const Rig, AnyOf<const Animation, const AnimationStates>, Optional<const AnimationLayers>,
                     Optional<const RootMotion>, Optional<const AnimationEvents>, Optional<const Name>>;

/// Where the parent of a node is in its model.
animation::JointPose place_of_parent(const animation::PoseLayout& layout, const animation::Pose& pose,
                                     std::uint32_t node) {
    animation::JointPose place;
    for (std::int32_t at = layout.parents[node]; at >= 0; at = layout.parents[static_cast<std::size_t>(at)]) {
        const animation::JointPose& above = pose.joints[static_cast<std::size_t>(at)];
        place.translation = above.translation + above.rotation * (above.scale * place.translation);
        place.rotation = above.rotation * place.rotation;
        place.scale = above.scale * place.scale;
    }
    return place;
}

/// What is written beside the models.
struct Targets {
    const TypeRegistry* types;
    Query<Camera> cameras;
    Query<Light> lights;
    Query<Surface> surfaces;
    Query<Transform> places;
    Query<MorphWeights> morphs;
    Query<Animation> animations;
    Query<AnimationStates> states;
    Query<AnimationLayers> layers;
};

template <class C> void* component_in(const Query<C>& query, Entity entity) {
    const auto found = query.find(entity);
    return found ? &std::get<C&>(*found) : nullptr;
}

void* component_of(const Targets& targets, const RigPointer& pointer) {
    if (pointer.component == "camera") return component_in(targets.cameras, pointer.entity);
    if (pointer.component == "light") return component_in(targets.lights, pointer.entity);
    return pointer.component == "surface" ? component_in(targets.surfaces, pointer.entity) : nullptr;
}

/// As the field has it: the alternative of `like`.
FieldValue field_value(const FieldValue& like, std::span<const float> values) {
    if (std::holds_alternative<bool>(like)) return values[0] != 0.0f;
    if (std::holds_alternative<glm::vec3>(like) && values.size() == 3)
        return glm::vec3(values[0], values[1], values[2]);
    return double{values[0]};
}

/// Nodes that no clip moves are left to whoever else does.
void write_pose(const Rig& rig, const ModelClips& clips, ModelPlayer& player, const Targets& targets) {
    const animation::PoseLayout& layout = clips.set.layout;
    const animation::Pose& pose = player.mix.pose;
    const bool first = player.shown.joints.empty();
    for (std::size_t node = 0; node < pose.joints.size(); ++node) {
        if (!clips.animated[node] || (!first && pose.joints[node] == player.shown.joints[node])) continue;
        const auto found = targets.places.find(rig.nodes[node]);
        if (!found) continue;
        Transform& transform = std::get<Transform&>(*found);
        const animation::JointPose& joint = pose.joints[node];
        transform = {joint.translation, joint.rotation, joint.scale};
    }
    for (std::size_t node = 0; node < rig.morphs.size(); ++node) {
        const std::size_t count = layout.weights_of(node);
        const auto now = pose.weights.begin() + layout.first_weight[node];
        if (count == 0 || (!first && std::equal(now, now + static_cast<std::ptrdiff_t>(count),
                                                player.shown.weights.begin() + layout.first_weight[node])))
            continue;
        if (const auto found = targets.morphs.find(rig.morphs[node]))
            std::get<MorphWeights&>(*found).values.assign(now, now + static_cast<std::ptrdiff_t>(count));
    }
    player.shown = pose;
}

/// Moves the model itself by what its root joint would have moved.
void move_model(Entity model, const animation::PoseLayout& layout, const ModelPlayer& player, const Targets& targets) {
    const auto found = targets.places.find(model);
    if (!player.mix.root_motion || !found) return;
    const animation::RigidMotion motion = animation::in_outer_space(
        player.mix.motion, place_of_parent(layout, player.mix.pose, player.mix.root_motion->node));
    Transform& transform = std::get<Transform&>(*found);
    transform.translation += transform.rotation * (transform.scale * glm::vec3(motion.translation));
    transform.rotation = glm::normalize(transform.rotation * glm::quat(motion.rotation));
}

/// Sets the fields that a clip's pointers name. Values outside a field's range, as splines can give them, are dropped.
void write_pointers(const Rig& rig, const ModelClips& clips, const ModelPlayer& player, const Targets& targets) {
    if (player.mix.pointers.empty() || player.mix.sources.front().clip < 0) return;
    const auto clip = static_cast<std::uint32_t>(player.mix.sources.front().clip);
    for (const RigPointer& pointer : std::ranges::equal_range(rig.pointers, clip, {}, &RigPointer::clip)) {
        const animation::PointerChannel& channel = clips.set.clips[clip].pointers[pointer.channel];
        const std::span<const float> values = std::span(player.mix.pointers).subspan(channel.first, channel.components);
        const TypeInfo* type = targets.types->find(pointer.component);
        const FieldInfo* field = type ? type->field(pointer.field) : nullptr;
        void* component = component_of(targets, pointer);
        if (!field || !component) continue;
        const FieldValue value = field_value(field->default_value, values);
        if (field->fault(value).empty()) field->set(component, value);
    }
}

class AnimationSystem {
public:
    explicit AnimationSystem(const TypeRegistry& types) : types_(&types) {}

    void operator()(Models models, Query<Transform> places, Query<MorphWeights> morphs, Query<Animation> animations,
                    Query<AnimationStates> states, Query<AnimationLayers> layers, Query<Camera> cameras,
                    Query<Light> lights, Query<Surface> surfaces, Removed<Rig> gone, const ClipStore& store,
                    const Time& time, AnimationCounts& counts, EventWriter<ClipEvent> events) {
        for (const Entity entity : gone) players_.erase(entity);
        collect(models, store, time.delta);
        parallel_for(active_.size(), [this](std::size_t i) { active_[i].player->mix.run(*active_[i].clips); });
        counts = {active_.size(), 0};
        const Targets targets{types_, cameras, lights, surfaces, places, morphs, animations, states, layers};
        for (const Active& active : active_) {
            write(active, targets);
            counts.clips += active.player->mix.sources.size() + active.player->mix.layers.size();
        }
        for (ClipEvent& event : passed_) events.send(std::move(event));
        active_.clear();
        passed_.clear();
    }

private:
    struct Active {
        Entity entity;
        const Rig* rig;
        const ModelClips* clips;
        ModelPlayer* player;
        PlayRequest request;
    };

    void collect(const Models& models, const ClipStore& store, double delta) {
        for (auto [entity, rig, animation, states, layers, root_motion, events, name] : models) {
            std::unique_ptr<ModelPlayer>& player = players_[entity];
            if (!player) player = std::make_unique<ModelPlayer>();
            const PlayRequest request{animation, states, layers, root_motion};
            const ModelClips& clips = store.clips(rig.clips);
            std::vector<std::string> warnings;
            const bool moved = player->advance(request, clips, delta, warnings);
            for (const std::string& warning : warnings)
                log_warning((name ? name->text : std::string("model")) + ": " + warning);
            if (!moved) continue;
            active_.push_back({entity, &rig, &clips, player.get(), request});
            if (events) player->collect_events(entity, clips, *events, passed_);
        }
    }

    /// The new pose, and how far the components have come.
    static void write(const Active& active, const Targets& targets) {
        ModelPlayer& player = *active.player;
        write_pose(*active.rig, *active.clips, player, targets);
        write_pointers(*active.rig, *active.clips, player, targets);
        move_model(active.entity, active.clips->set.layout, player, targets);
        if (active.request.states)
            std::get<AnimationStates&>(*targets.states.find(active.entity)) = player.states;
        else if (!(*active.request.animation == player.animation))
            std::get<Animation&>(*targets.animations.find(active.entity)).time = player.animation.time;
        if (active.request.layers && !(*active.request.layers == player.layers))
            std::get<AnimationLayers&>(*targets.layers.find(active.entity)) = player.layers;
    }

    const TypeRegistry* types_;
    std::unordered_map<Entity, std::unique_ptr<ModelPlayer>> players_;
    std::vector<Active> active_;
    std::vector<ClipEvent> passed_;
};

} // namespace

void register_animation(App& app) {
    app.add_component<Animation>();
    app.add_component<RootMotion>();
    World& world = app.world();
    if (!world.find_resource<ClipStore>()) world.set_resource(ClipStore{});
    world.set_resource(AnimationCounts{});
    for (ScenePart& part : std::array{animation_states_part(), animation_layers_part(), animation_events_part()})
        add_scene_part(world, std::move(part));
    // The players are too heavy, and too much the system's own, to be copied with it.
    app.add_system(Stage::animate, "animation",
                   [system = std::make_shared<AnimationSystem>(app.types())](
                       Models models, Query<Transform> places, Query<MorphWeights> morphs, Query<Animation> animations,
                       Query<AnimationStates> states, Query<AnimationLayers> layers, Query<Camera> cameras,
                       Query<Light> lights, Query<Surface> surfaces, Removed<Rig> gone, const ClipStore& store,
                       const Time& time, AnimationCounts& counts, EventWriter<ClipEvent> events) {
                       (*system)(models, places, morphs, animations, states, layers, cameras, lights, surfaces, gone,
                                 store, time, counts, events);
                   });
}

} // namespace hachure
