#include <hachure/runtime/app/app.h>
#include <hachure/systems/implicit_brush/brush_frame.h>
#include <hachure/systems/implicit_brush/brush_passes.h>
#include <hachure/systems/implicit_brush/feature_aovs.h>
#include <hachure/systems/implicit_brush/implicit_brush.h>
#include <hachure/systems/implicit_brush/select_brushes.h>

#include <memory>

namespace hachure {

void register_implicit_brush(App& app) {
    app.add_component<ImplicitBrush>();
    app.add_component<FeatureImage>();
    app.world().set_resource(BrushFrame{});
    if (!app.world().find_resource<LineLayer>()) app.world().set_resource(LineLayer{});
    if (!app.world().find_resource<PictureList>()) app.world().set_resource(PictureList{});
    FrameRequests& requests = frame_requests(app.world());
    know_feature_aovs(requests);
    requests.known.push_back(
        {"brush_weight", "how much a pixel counts in the brush that it counts most in, 0 to 1", {"brush_weight"}});
    app.add_system(Stage::material, "implicit_brush.select", select_brushes)
        .after("surface.collect")
        .after("picture.collect")
        .after("edge_lines.select")
        .after("abstracted_lines.select")
        .after("abstracted_lines.strokes");
    app.add_system(Stage::render, "implicit_brush.pass",
                   [passes = std::make_shared<BrushPasses>()](World& world) { passes->declare(world); })
        .after("surface.passes")
        .after("picture.pass")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .after("abstracted_lines.pass")
        .after("velocity.pass");
}

} // namespace hachure
