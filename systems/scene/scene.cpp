#include <hachure/components/scene.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/scene/scene.h>

namespace hachure {

void register_scene(App& app) {
    if (!app.world().find_resource<SceneDocument>()) app.world().set_resource(SceneDocument{});
}

} // namespace hachure
