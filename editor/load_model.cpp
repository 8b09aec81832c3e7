#include <hachure/editor/load_model.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/model/spawn_model.h>

#include <algorithm>
#include <cmath>

namespace hachure {

namespace {

/// Beyond this, squares of lengths no longer fit a float.
constexpr float largest_coordinate = 1e15f; // metres

bool fits(const glm::vec3& point) {
    return std::abs(point.x) <= largest_coordinate && std::abs(point.y) <= largest_coordinate &&
           std::abs(point.z) <= largest_coordinate;
}

} // namespace

void load_model(App& app, const assets::Model& model, const std::filesystem::path& file, Canvas canvas) {
    World& world = app.world();
    world.set_resource(canvas);
    const SpawnedModel spawned = spawn_model(world, model);
    for (const std::string& warning : model.warnings) log_warning(file.string() + ": " + warning);
    for (const std::string& warning : spawned.warnings) log_warning(file.string() + ": " + warning);
    if (spawned.points.empty()) throw Error(file.string(), "has nothing to draw: its scene holds no triangle");
    if (!std::ranges::all_of(spawned.points, fits))
        throw Error(file.string(), "is too large to be drawn: a vertex lies more than 1e15 m from the origin");
    if (spawned.cameras.empty()) spawn_framing_camera(world, spawned.points, canvas);
    if (spawned.lights.empty()) spawn_default_light(world);
}

} // namespace hachure
