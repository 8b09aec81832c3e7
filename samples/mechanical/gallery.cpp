#include "gallery.h"

#include <hachure/components/animation.h>
#include <hachure/components/edge_lines.h>
#include <hachure/systems/styles/style.h>

#include <algorithm>
#include <iterator>
#include <string_view>

using namespace hachure;

namespace {

/// A built-in style, with lines of that width.
void dress_in(App& app, const SpawnedModel& model, const char* style, float line_width) {
    apply_style(app.world(), find_style(app.types(), style), model.root);
    for (const Entity surface : model.surfaces)
        if (EdgeLines* lines = app.world().find_mutable<EdgeLines>(surface)) lines->width = line_width;
}

void stand_still_walking(App& app, const SpawnedModel& model) {
    for (const std::string_view clip : {"Walking_A", "Walk", "Run"})
        if (std::ranges::find(model.clips, clip) != model.clips.end())
            return static_cast<void>(app.world().add(
                model.root, Animation{.clip = std::string(clip), .playing = false, .offset = 0.25f, .fade = 0.0f}));
}

} // namespace

assets::Model whitened(assets::Model model) {
    model.materials = {{.name = "white"}};
    for (assets::Mesh& mesh : model.meshes)
        for (assets::Primitive& primitive : mesh.primitives) primitive.material = 0;
    return model;
}

std::vector<Cell> gallery(const assets::Model& character, const assets::Model& statue,
                          const assets::Model& white_statue, const assets::Model& part) {
    const auto in_style = [](const char* style) {
        return [style](App& app, const SpawnedModel& model, float width) {
            dress_in(app, model, style, width);
            stand_still_walking(app, model);
        };
    };
    std::vector<Cell> cells = {{&character, "cool to warm tones", in_style("gooch"), half_profile(), 0.86f},
                               {&character, "toon", in_style("toon"), half_profile(), 0.86f},
                               {&statue, "tones and edge lines", in_style("gooch"), half_profile()},
                               {&white_statue, "edge lines alone",
                                [](App& app, const SpawnedModel& model, float width) {
                                    for (const Entity surface : model.surfaces)
                                        app.world().add(surface, EdgeLines{.suggestive = true, .width = width});
                                },
                                half_profile()}};
    std::ranges::move(figure_10(part, MetalSource::around_axis, leaning()), std::back_inserter(cells));
    return cells;
}
