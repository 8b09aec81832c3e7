#include "gallery.h"

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/animation.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/shade_strokes.h>
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

/// Pixels of the picture are finer than those that lengths in px are meant for.
constexpr float usual_line_width = 1.4f;

void dress_in_tone_lines(App& app, const SpawnedModel& model, float line_width) {
    apply_style(app.world(), find_style(app.types(), "lines"), model.root);
    for (const Entity surface : model.surfaces)
        app.world().get_mutable<AbstractedLines>(surface).width *= 0.6f * line_width / usual_line_width;
}

/// Brushes are children of what they paint on: contours over valleys.
void dress_in_brushes(App& app, const SpawnedModel& model, float line_width) {
    apply_style(app.world(), find_style(app.types(), "brush"), model.root);
    const float pixel = line_width / usual_line_width;
    for (const ImplicitBrush& brush :
         {ImplicitBrush{
              .order = 1, .diffusion = 0, .window = 4.0f * pixel, .spread = 0.5f * pixel, .size = 0.9f * pixel},
          ImplicitBrush{.feature = BrushFeature::valleys,
          .window = 5.0f * pixel,
          .peak_low = 0.15f,
          .peak_high = 0.45f,
          .spread = 0.6f * pixel,
          .size = 0.9f * pixel,
          .weak_size = 0.4f * pixel,
          .size_by = BrushDriver::height,
          .size_low = 0.2f,
          .size_high = 0.9f}})
        app.world().set_parent(app.world().create_with(ImplicitBrush(brush)), model.root);
}

/// Strokes in the dark of a style.
void dress_in_strokes(App& app, const SpawnedModel& model, const char* style, float line_width, ShadeStrokes strokes) {
    dress_in(app, model, style, line_width);
    stand_still_walking(app, model);
    strokes.line_width *= 0.5f * line_width / usual_line_width; // cells are small, and their pixels are fine
    for (const Entity surface : model.surfaces) app.world().add(surface, ShadeStrokes(strokes));
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
    cells.push_back({&statue, "lines of tone", dress_in_tone_lines, half_profile()});
    cells.push_back({&white_statue, "brushes", dress_in_brushes, half_profile()});
    cells.push_back(
        {&white_statue, "shade strokes",
         [](App& app, const SpawnedModel& model, float width) { dress_in_strokes(app, model, "strokes", width, {}); },
         half_profile()});
    cells.push_back(
        {&character, "strokes on toon",
         [](App& app, const SpawnedModel& model, float width) {
             dress_in_strokes(app, model, "toon", width, {.no_shade = 0.6f, .color = {0.06f, 0.02f, 0.06f}});
         },
         half_profile(), 0.86f});
    std::ranges::move(figure_10(part, MetalSource::around_axis, leaning()), std::back_inserter(cells));
    return cells;
}
