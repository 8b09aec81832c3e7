#include <hachure/components/animation_events.h>
#include <hachure/components/scene_event.h>
#include <hachure/components/script.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/systems/script/script.h>
#include <hachure/systems/script/script_engine.h>
#include <hachure/systems/script/script_errors.h>

#include <memory>

namespace hachure {

void register_script(App& app) {
    app.add_component<Script>();
    if (!app.world().find_resource<ScriptErrors>()) app.world().set_resource(ScriptErrors{});
    app.schedule().add_event<SceneEvent>();
    app.schedule().add_event<ClipEvent>();
    app.add_system(Stage::script, "script.run",
                   [engine = std::make_shared<script::ScriptEngine>(app.types())](World& world) {
                       engine->run(world, world.resource<Time>());
                   })
        .after("timeline");
}

} // namespace hachure
