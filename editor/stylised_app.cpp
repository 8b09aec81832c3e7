#include <hachure/components/name.h>
#include <hachure/editor/stylised_app.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/compose/compose.h>
#include <hachure/systems/edge_lines/edge_lines.h>
#include <hachure/systems/gooch/gooch.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/surface/surface.h>
#include <hachure/systems/transform/transform.h>

namespace hachure {

void register_capabilities(App& app) {
    app.add_component<Name>();
    register_transform(app);
    register_camera(app);
    register_light(app);
    register_surface(app);
    register_gooch(app);
    register_edge_lines(app);
    register_compose(app);
}

void load_model(App& app, const assets::Model& model, const std::filesystem::path& file, Canvas canvas) {
    World& world = app.world();
    world.set_resource(canvas);
    const SpawnedModel spawned = spawn_model(world, model);
    for (const std::string& warning : model.warnings) log_warning(file.string() + ": " + warning);
    for (const std::string& warning : spawned.warnings) log_warning(file.string() + ": " + warning);
    if (spawned.points.empty()) throw Error(file.string(), "has nothing to draw: its scene holds no triangle");
    if (spawned.cameras.empty()) spawn_framing_camera(world, spawned.points, canvas);
    if (spawned.lights.empty()) spawn_default_light(world);
}

} // namespace hachure
