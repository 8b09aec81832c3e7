#include <hachure/components/animation.h>
#include <hachure/components/name.h>
#include <hachure/components/rig.h>
#include <hachure/components/scene.h>
#include <hachure/editor/load_model.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/clip_store.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/model/clip_points.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hachure {

namespace {

/// Beyond this, squares of lengths no longer fit a float.
constexpr float largest_coordinate = 1e15f; // metres

bool fits(const glm::vec3& point) {
    return std::abs(point.x) <= largest_coordinate && std::abs(point.y) <= largest_coordinate &&
           std::abs(point.z) <= largest_coordinate;
}

/// A model that moves: from the pose of the clip's start, without a fade to it.
void start_clip(World& world, const assets::Model& model, SpawnedModel& spawned, const std::filesystem::path& file,
                std::string clip) {
    const bool chosen = !clip.empty();
    // What a file plays by itself it plays as it says, with its speed and all.
    if (const Animation* own = world.find<Animation>(spawned.root); own && !chosen) clip = own->clip;
    if (clip.empty() && spawned.clips.empty()) return;
    if (clip.empty()) clip = spawned.clips.front();
    if (std::ranges::find(spawned.clips, clip) == spawned.clips.end()) {
        std::string names;
        for (const std::string& name : spawned.clips) names += (names.empty() ? "" : ", ") + name;
        throw Error(file.string(), "has no clip '" + clip + "'", names.empty() ? "it has none" : "there are " + names);
    }
    // The camera is to see all of the clip, not only how the model stands at rest.
    const animation::ClipSet& set = world.resource<ClipStore>().clips(world.get<Rig>(spawned.root).clips).set;
    spawned.points = clip_points(model, set, set.clips[*animation::find_clip(set, clip)]);
    if (!chosen && world.has<Animation>(spawned.root)) {
        world.get_mutable<Animation>(spawned.root).clip = std::move(clip);
        return;
    }
    world.add(spawned.root, Animation{.clip = std::move(clip)});
}

} // namespace

SpawnedModel load_model(App& app, const assets::Model& model, const std::filesystem::path& file, Canvas canvas,
                        const std::optional<std::string>& clip) {
    World& world = app.world();
    world.set_resource(canvas);
    SpawnedModel spawned = spawn_model(world, model, &app.types());
    for (const std::string& warning : model.warnings) log_warning(file.string() + ": " + warning);
    for (const std::string& warning : spawned.warnings) log_warning(file.string() + ": " + warning);
    if (spawned.points.empty()) throw Error(file.string(), "has nothing to draw: its scene holds no triangle");
    check_drawable(file, spawned.points);
    const Animation* own = world.find<Animation>(spawned.root);
    if (clip || (own && !own->clip.empty())) start_clip(world, model, spawned, file, clip.value_or(""));
    // What a scene file of this world has to say of it: the model and what its root carries.
    world.for_each_descendant(spawned.root, [&](Entity entity) { world.add(entity, Unsaved{}); });
    world.add(spawned.root, SceneReference{.file = file, .own_name = world.get<Name>(spawned.root).text});
    if (spawned.cameras.empty()) world.add(spawn_framing_camera(world, spawned.points, canvas), Unsaved{});
    if (spawned.lights.empty()) world.add(spawn_default_light(world), Unsaved{});
    return spawned;
}

void check_drawable(const std::filesystem::path& file, std::span<const glm::vec3> points) {
    if (!std::ranges::all_of(points, fits))
        throw Error(file.string(), "is too large to be drawn: a vertex lies more than 1e15 m from the origin");
}

} // namespace hachure
