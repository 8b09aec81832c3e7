#include <hachure/components/edge_lines.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/edge_lines/edge_lines.h>
#include <hachure/systems/edge_lines/line_frame.h>
#include <hachure/systems/edge_lines/line_pass.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

bool draws_anything(const EdgeLines& lines) {
    return lines.width > 0.0f && (lines.silhouette || lines.smooth_silhouette || lines.crease || lines.border ||
                                  lines.material || lines.intersection || lines.suggestive);
}

LineDraw draw_of(const LinedItem& lined, const SegmentRange& segments) {
    return {.entity = lined.item->entity, .segments = segments, .taper = lined.lines->taper, .exact = lined.clipped};
}

void add_hidden(LineGroups& groups, const LinedItem& item, HiddenLines style) {
    if (style == HiddenLines::none) return;
    for (std::size_t kind = 0; kind < drawn_kinds; ++kind) {
        LineDraw draw = draw_of(item, item.batch->hidden[kind]);
        draw.hidden = true;
        draw.width_factor = item.lines->hidden_width;
        draw.dash = style == HiddenLines::dashed ? item.lines->dash : 0.0f;
        groups.add(item.lines->hidden_color, draw);
    }
}

void group_lines(std::span<const LinedItem> items, bool hidden_wanted, EdgeLineFrame& frame) {
    frame.picture.clear();
    frame.hidden.clear();
    for (const LinedItem& item : items) add_hidden(frame.picture, item, item.lines->hidden);
    for (std::size_t kind = 0; kind < drawn_kinds; ++kind)
        for (const LinedItem& item : items)
            frame.picture.add(color_of(*item.lines, static_cast<DrawnKind>(kind)),
                              draw_of(item, item.batch->kinds[kind]));
    if (!hidden_wanted) return;
    for (const LinedItem& item : items)
        add_hidden(frame.hidden, item,
                   item.lines->hidden == HiddenLines::none ? HiddenLines::solid : item.lines->hidden);
}

void update_batches(Query<const EdgeLines> styled, const DrawList& list, const MeshStore& store, const View& view,
                    FrameRequests& requests, EdgeLineFrame& frame, LineLayer& layer) {
    std::vector<LinedItem> items;
    frame.image.clear();
    const bool all_on_cpu = std::ranges::none_of(list.items, [](const DrawItem& item) { return item.shape.on_gpu; });
    for (const DrawItem& item : list.items) {
        const auto found = styled.find(item.entity);
        if (!found || !draws_anything(std::get<const EdgeLines&>(*found))) continue;
        const EdgeLines& lines = std::get<const EdgeLines&>(*found);
        if (lines.method == LineMethod::image)
            frame.image.add(item, lines, view);
        else
            items.push_back({&item, &lines, lines.visibility == LineVisibility::exact && all_on_cpu});
    }
    if (frame.image.any()) requests.textures.insert("surface_code");
    frame.batches.update(items, store, list, view);
    frame.drawn.clear();
    frame.rect = frame.image.rect();
    frame.probes = false;
    for (const LinedItem& lined : items) {
        frame.drawn.push_back(lined.item->entity);
        frame.probes = frame.probes || !lined.clipped;
        const float wide = std::min(lined.batch->widest * std::max(1.0f, lined.lines->hidden_width), 1e5f);
        frame.rect = united(frame.rect, grown(lined.item->rect, static_cast<int>(std::ceil(wide)) + 2, view));
    }
    group_lines(items, requests.wants("hidden_lines"), frame);
    layer.set("edge_lines", frame.rect);
}

} // namespace

void register_edge_lines(App& app) {
    app.add_component<EdgeLines>();
    app.world().set_resource(EdgeLineFrame{});
    if (!app.world().find_resource<LineLayer>()) app.world().set_resource(LineLayer{});
    frame_requests(app.world())
        .known.push_back({"line_layer",
                          "the lines that lie over the picture, colour times coverage, and coverage; linear",
                          {"R", "G", "B", "A"}});
    frame_requests(app.world())
        .known.push_back({"hidden_lines",
                          "lines behind surfaces, as line_layer holds those that are seen; solid where the component "
                          "asks for none",
                          {"R", "G", "B", "A"}});
    app.add_system(Stage::material, "edge_lines.select", update_batches).after("surface.collect");
    app.add_system(Stage::render, "edge_lines.pass", declare_line_pass)
        .after("surface.passes")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass");
}

} // namespace hachure
