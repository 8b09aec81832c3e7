#include <hachure/components/edge_lines.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/edge_lines/edge_line_batch.h>
#include <hachure/systems/edge_lines/edge_lines.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// What this frame draws. A resource.
struct EdgeLineFrame {
    EdgeLineBatches batches;
    std::vector<Entity> drawn; ///< in the order of the DrawList
    gpu::Rect rect;            ///< where their lines can be
};

bool draws_anything(const EdgeLines& lines) {
    return lines.width > 0.0f && (lines.silhouette || lines.crease || lines.border);
}

gpu::Rect united(const gpu::Rect& a, const gpu::Rect& b) {
    if (a.width <= 0 || a.height <= 0) return b;
    if (b.width <= 0 || b.height <= 0) return a;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

gpu::Rect grown(const gpu::Rect& rect, int margin, const View& view) {
    const int x = std::max(0, rect.x - margin), y = std::max(0, rect.y - margin);
    return {x, y, std::min(view.width, rect.x + rect.width + margin) - x,
            std::min(view.height, rect.y + rect.height + margin) - y};
}

void update_batches(Query<const EdgeLines> styled, const DrawList& list, const MeshStore& store, const View& view,
                    EdgeLineFrame& frame, LineLayer& layer) {
    frame.drawn.clear();
    frame.rect = {};
    for (const DrawItem& item : list.items) {
        const auto found = styled.find(item.entity);
        if (!found) continue;
        const EdgeLines& lines = std::get<const EdgeLines&>(*found);
        if (!draws_anything(lines)) continue;
        frame.batches.update(store, item, lines, view);
        frame.drawn.push_back(item.entity);
        frame.rect = united(frame.rect, grown(item.rect, static_cast<int>(std::ceil(lines.width)) + 2, view));
    }
    layer.rect = frame.rect;
}

struct LinePass {
    gpu::TextureHandle depth_buffer, layer;
};

void draw_batch(RenderContext& render, const EdgeLines& lines, const EdgeLineBatch& batch) {
    gpu::Program& program =
        render.shaders->program({.vertex = "edge_lines/edge_lines.vert", .fragment = "edge_lines/edge_lines.frag"});
    program.set("world_from_entity", batch.world_from_entity);
    program.set("half_width", 0.5f * lines.width);
    program.set("color", lines.color);
    program.use();
    batch.vertex_array.bind();
    gpu::gl().DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.segments.size()));
}

void draw_lines(World& world, RenderContext& render, const LinePass& data, gpu::PassContext& pass) {
    EdgeLineFrame& frame = world.resource_mutable<EdgeLineFrame>();
    const View& view = world.resource<View>();
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({pass.texture(data.layer)});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, view.width, view.height}, .scissor = frame.rect, .blend = gpu::Blend::max});
    framebuffer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    render.view_uniforms.bind(view, world.resource<LightList>());
    render.backend->texture(pass.texture(data.depth_buffer)).bind(0);
    for (const Entity entity : frame.drawn) {
        EdgeLineBatch& batch = frame.batches.get(entity);
        batch.upload();
        if (!batch.segments.empty()) draw_batch(render, world.get<EdgeLines>(entity), batch);
    }
}

void declare_pass(World& world) {
    EdgeLineFrame& frame = world.resource_mutable<EdgeLineFrame>();
    // Here and not where edges are chosen, which happens on any thread: batches own buffers of the context.
    frame.batches.forget_all_but(frame.drawn);
    if (frame.drawn.empty() || frame.rect.width <= 0 || frame.rect.height <= 0) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    graph.add_pass<LinePass>(
        "edge_lines",
        [&](gpu::PassBuilder& pass, LinePass& data) {
            data.depth_buffer = pass.read(graph.find("depth_buffer"));
            const gpu::TextureDesc& desc = graph.desc(data.depth_buffer);
            data.layer = pass.create("line_layer", {desc.width, desc.height, gpu::Format::rgba16f});
            graph.publish("line_layer", data.layer);
            pass.depends_on(world.resource<DrawList>().key, world.last_changed<EdgeLines>(),
                            render.shaders->generation());
            pass.covers(static_cast<std::uint64_t>(frame.rect.width) * static_cast<std::uint64_t>(frame.rect.height));
        },
        [&world, &render](const LinePass& data, gpu::PassContext& pass) { draw_lines(world, render, data, pass); });
}

} // namespace

void register_edge_lines(App& app) {
    app.add_component<EdgeLines>();
    app.world().set_resource(EdgeLineFrame{});
    if (!app.world().find_resource<LineLayer>()) app.world().set_resource(LineLayer{});
    app.add_system(Stage::material, "edge_lines.select", update_batches).after("surface.collect");
    app.add_system(Stage::render, "edge_lines.pass", declare_pass)
        .after("surface.passes")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass");
}

} // namespace hachure
