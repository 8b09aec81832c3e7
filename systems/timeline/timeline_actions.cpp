#include <hachure/components/animation.h>
#include <hachure/components/animation_states.h>
#include <hachure/components/camera.h>
#include <hachure/components/rig.h>
#include <hachure/components/scene_event.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/systems/timeline/timeline_actions.h>

namespace hachure {
namespace {

/// Whom a path names; null, with a warning, when there is nobody.
Entity called(const TimelineStageHands& hands, const std::string& path) {
    const Entity found = hands.targets.find(hands.world, hands.carrier, path);
    if (!found) hands.warnings.say("timeline: there is no entity '" + path + "'");
    return found;
}

void spawn(const TimelineStageHands& hands, const TimelineAction& action) {
    const Spawner* spawner = hands.world.find_resource<Spawner>();
    if (!spawner || !spawner->spawn) {
        hands.warnings.say("timeline: nothing can be spawned here, as '" + action.what + "'");
        return;
    }
    const Entity parent = action.on.empty() ? Entity::null : called(hands, action.on);
    if (!action.on.empty() && !parent) return;
    try {
        // A copy: what is spawned may set another spawner.
        const Spawner copy = *spawner;
        copy.spawn(hands.world, {action.what, parent, action.name});
    } catch (const Error& error) {
        hands.warnings.say(std::string("timeline: ") + error.what());
    }
}

void set_parent(const TimelineStageHands& hands, const TimelineAction& action) {
    const Entity child = called(hands, action.on);
    if (!child) return;
    if (action.what.empty()) return hands.world.clear_parent(child);
    const Entity parent = called(hands, action.what);
    if (!parent) return;
    try {
        hands.world.set_parent(child, parent);
    } catch (const HierarchyCycle&) {
        hands.warnings.say("timeline: '" + action.on + "' can't be put below '" + action.what +
                           "', which is itself below it");
    }
}

void play_clip(const TimelineStageHands& hands, const TimelineAction& action) {
    const Entity model = called(hands, action.on);
    if (!model) return;
    World& world = hands.world;
    if (const Animation* animation = world.find<Animation>(model)) {
        if (animation->clip != action.what) world.find_mutable<Animation>(model)->clip = action.what;
    } else if (world.has<Rig>(model)) {
        world.add(model, Animation{.clip = action.what});
    } else {
        hands.warnings.say("timeline: '" + action.on + "' is no model that plays clips");
    }
}

void set_parameters(const TimelineStageHands& hands, const TimelineAction& action) {
    const Entity model = called(hands, action.on);
    if (!model) return;
    const AnimationStates* states = hands.world.find<AnimationStates>(model);
    if (!states) {
        hands.warnings.say("timeline: '" + action.on + "' has no animation states");
        return;
    }
    for (const auto& [name, value] : action.parameters) {
        const auto parameter = animation::find_parameter(states->machine, name);
        if (!parameter || *parameter >= states->parameters.size())
            hands.warnings.say("timeline: the animation states of '" + action.on + "' have no parameter '" + name +
                               "'");
        else if (states->parameters[*parameter] != value)
            hands.world.find_mutable<AnimationStates>(model)->parameters[*parameter] = value;
    }
}

void cut_to(const TimelineStageHands& hands, const TimelineAction& action) {
    const Entity camera = called(hands, action.on);
    if (!camera) return;
    if (!hands.world.has<Camera>(camera)) {
        hands.warnings.say("timeline: '" + action.on + "' is no camera");
        return;
    }
    std::vector<Entity> wrong;
    for (auto [entity, each] : hands.world.query<const Camera>())
        if (each.active != (entity == camera)) wrong.push_back(entity);
    for (const Entity entity : wrong) hands.world.find_mutable<Camera>(entity)->active = entity == camera;
}

} // namespace

void do_action(const TimelineStageHands& hands, const TimelineAction& action) {
    switch (action.kind) {
    case TimelineActionKind::spawn:
        return spawn(hands, action);
    case TimelineActionKind::destroy:
        if (const Entity entity = called(hands, action.on)) hands.world.destroy(entity);
        return;
    case TimelineActionKind::parent:
        return set_parent(hands, action);
    case TimelineActionKind::clip:
        return play_clip(hands, action);
    case TimelineActionKind::state:
        return set_parameters(hands, action);
    case TimelineActionKind::camera:
        return cut_to(hands, action);
    case TimelineActionKind::event:
        if (const Entity entity = called(hands, action.on)) send_event(hands.world, SceneEvent{entity, action.what});
        return;
    }
}

} // namespace hachure
