#include <hachure/runtime/app/app.h>
#include <hachure/systems/shade_strokes/select_shade.h>
#include <hachure/systems/shade_strokes/shade_aovs.h>
#include <hachure/systems/shade_strokes/shade_passes.h>
#include <hachure/systems/shade_strokes/shade_strokes.h>

#include <memory>

namespace hachure {

void register_shade_strokes(App& app) {
    app.add_component<ShadeStrokes>();
    app.add_component<ShadeVolume>();
    World& world = app.world();
    world.set_resource(ShadeFrame{});
    world.set_resource(ShadeNeeds{});
    world.set_resource(ShadeCounts{});
    if (!world.find_resource<LightList>()) world.set_resource(LightList{});
    if (!world.find_resource<LightStrength>()) world.set_resource(LightStrength{});
    if (!world.find_resource<MeshStore>()) world.set_resource(MeshStore{});
    if (!world.find_resource<LineLayer>()) world.set_resource(LineLayer{});
    know_shade_aovs(frame_requests(world));
    app.add_system(Stage::material, "shade_strokes.select",
                   [select = std::make_shared<SelectShade>()](
                       StyledSurfaces styled, Removed<ShadeStrokes> bare,
                       Query<const ShadeVolume, const WorldTransform> volumes, const DrawList& list,
                       const MeshStore& store, const LightList& lights, const LightStrength& strength, const View& view,
                       const Time& time, ShadeFrame& frame, ShadeNeeds& needs, ShadeCounts& counts, LineLayer& layer) {
                       (*select)(styled, bare, volumes, list, store, lights, strength, view, time, frame, needs, counts,
                                 layer);
                   })
        .after("surface.collect")
        .after("edge_lines.select")
        .after("abstracted_lines.select")
        .after("implicit_brush.select");
    app.add_system(Stage::render, "shade_strokes.pass",
                   [passes = std::make_shared<ShadePasses>(), aovs = std::make_shared<ShadeAovs>()](World& drawn) {
                       request_shade_sources(drawn.resource_mutable<FrameRequests>());
                       passes->declare(drawn);
                       aovs->declare(drawn);
                   })
        .after("surface.passes")
        .after("picture.pass")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .after("abstracted_lines.pass")
        .after("velocity.pass")
        .after("implicit_brush.pass");
}

} // namespace hachure
