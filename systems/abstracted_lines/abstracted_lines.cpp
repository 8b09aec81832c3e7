#include <hachure/runtime/app/app.h>
#include <hachure/systems/abstracted_lines/abstracted_lines.h>
#include <hachure/systems/abstracted_lines/select_lines.h>
#include <hachure/systems/abstracted_lines/stroke_frame.h>
#include <hachure/systems/abstracted_lines/stroke_passes.h>
#include <hachure/systems/abstracted_lines/tone_line_passes.h>

#include <memory>

namespace hachure {
namespace {

void add_aovs(std::vector<AovInfo>& known) {
    known.push_back({"tone",
                     "diffuse tone that abstracted lines are found in: 0 black, 1 white; 1 where nothing is drawn",
                     {"tone"}});
    known.push_back({"tone_specular", "specular tone that they are found in; 0 where nothing is drawn", {"tone"}});
    known.push_back({"ridge_distance",
                     "pixels to the middle of the line that a pixel belongs to, of diffuse and of specular tone; 1e10 "
                     "where there is none",
                     {"diffuse", "specular"}});
    known.push_back({"ridge_curvature",
                     "change of tone over half a line's width at that place, of diffuse and of specular tone: above 0 "
                     "in dark lines, below in highlights",
                     {"diffuse", "specular"}});
    for (const char* name : {"ridge_points", "specular_ridge_points"})
        known.push_back({name,
                         "pixels right and up from a pixel to the middle of the line that it belongs to, the curvature "
                         "there, and the opacity along the line; 0 where there is none",
                         {"right", "up", "curvature", "opacity"}});
    known.push_back({"line_opacity", "opacity of dark and of highlight lines of tone", {"dark", "highlight"}});
}

} // namespace

void register_abstracted_lines(App& app) {
    app.add_component<AbstractedLines>();
    app.add_component<ToneImage>();
    app.world().set_resource(ToneLineFrame{});
    app.world().set_resource(StrokeFrame{});
    if (!app.world().find_resource<StrokeSet>()) app.world().set_resource(StrokeSet{});
    if (!app.world().find_resource<MeshStore>()) app.world().set_resource(MeshStore{});
    if (!app.world().find_resource<LineLayer>()) app.world().set_resource(LineLayer{});
    if (!app.world().find_resource<PictureList>()) app.world().set_resource(PictureList{});
    add_aovs(frame_requests(app.world()).known);
    app.add_system(
           Stage::material, "abstracted_lines.select",
           [select = std::make_shared<SelectToneLines>()](
               Query<const AbstractedLines> styled, Query<const ToneImage> qualities, const DrawList& list,
               const PictureList& pictures, const View& view, FrameRequests& requests, ToneLineFrame& frame,
               LineLayer& layer) { (*select)(styled, qualities, list, pictures, view, requests, frame, layer); })
        .after("surface.collect")
        .after("picture.collect")
        .after("edge_lines.select");
    app.add_system(Stage::material, "abstracted_lines.strokes", select_strokes).after("abstracted_lines.select");
    app.add_system(
           Stage::render, "abstracted_lines.pass",
           [lines = std::make_shared<ToneLinePasses>(), strokes = std::make_shared<StrokePasses>()](World& world) {
               lines->declare(world);
               strokes->declare(world);
           })
        .after("surface.passes")
        .after("picture.pass")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .before("velocity.pass");
}

} // namespace hachure
