#include <hachure/components/name.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/abstracted_lines/abstracted_lines.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/compose/compose.h>
#include <hachure/systems/curvature/curvature.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/edge_lines/edge_lines.h>
#include <hachure/systems/gooch/gooch.h>
#include <hachure/systems/implicit_brush/implicit_brush.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/metal/metal.h>
#include <hachure/systems/paper/paper.h>
#include <hachure/systems/picture/picture.h>
#include <hachure/systems/scene/scene.h>
#include <hachure/systems/script/script.h>
#include <hachure/systems/shade_strokes/shade_strokes.h>
#include <hachure/systems/surface/surface.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/toon/toon.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/systems/velocity/velocity.h>

namespace hachure {

void register_capabilities(App& app) {
    app.add_component<Name>();
    register_scene(app);
    register_transform(app);
    register_timeline(app);
    register_script(app);
    register_animation(app);
    register_deform(app);
    register_curvature(app);
    register_camera(app);
    register_light(app);
    register_surface(app);
    register_picture(app);
    register_gooch(app);
    register_metal(app);
    register_toon(app);
    register_edge_lines(app);
    register_abstracted_lines(app);
    register_implicit_brush(app);
    register_shade_strokes(app);
    register_paper(app);
    register_compose(app);
    register_velocity(app);
}

} // namespace hachure
