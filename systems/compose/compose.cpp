#include <hachure/components/compose.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/compose/compose.h>

#include <array>

namespace hachure {
namespace {

struct BlankPass {
    gpu::TextureHandle color;
};

/// Takes surfaces away, where lines are to stand alone: after all that looks at them, before paper and lines.
void declare_blank(World& world) {
    const Compose* compose = world.find<Compose>(world.resource<View>().camera);
    if (!compose || compose->surfaces) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const glm::vec4 background(compose->background, 1.0f);
    graph.add_pass<BlankPass>(
        "blank",
        [&](gpu::PassBuilder& pass, BlankPass& data) {
            data.color = pass.write(graph.find("color"));
            graph.publish("color", data.color);
            pass.depends_on(background);
        },
        [&render, background](const BlankPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.color)});
            target.bind();
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}, .srgb_write = true});
            target.clear_color(0, std::array{background.r, background.g, background.b, background.a});
        });
}

struct OverlayPass {
    gpu::TextureHandle layer, color;
};

/// Lays the line layer, if the frame has one, over the shaded surfaces.
void declare_overlay(World& world, RenderContext& render) {
    gpu::FrameGraph& graph = render.graph;
    const gpu::Rect rect = world.resource<LineLayer>().rect();
    if (!graph.find("line_layer") || world.resource<LineLayer>().laid) return;
    graph.add_pass<OverlayPass>(
        "overlay",
        [&](gpu::PassBuilder& pass, OverlayPass& data) {
            data.layer = pass.read(graph.find("line_layer"));
            data.color = pass.write(graph.find("color"));
            graph.publish("color", data.color);
            pass.depends_on(render.shaders->generation());
            pass.draws_in(rect);
        },
        [&render, rect](const OverlayPass& data, gpu::PassContext& pass) {
            const gpu::TextureDesc& desc = pass.desc(data.color);
            render.backend->framebuffer({pass.texture(data.color)}).bind();
            render.draw_full_screen("compose/overlay.frag",
                                    {.viewport = {0, 0, desc.width, desc.height},
                                     .scissor = rect,
                                     .blend = gpu::Blend::premultiplied,
                                     .srgb_write = true},
                                    {pass.texture(data.layer)});
        });
}

struct DepthPass {
    gpu::TextureHandle depth_buffer, depth;
};

void declare_depth(World& world, RenderContext& render) {
    gpu::FrameGraph& graph = render.graph;
    if (!world.resource<FrameRequests>().wants("depth")) return;
    graph.add_pass<DepthPass>(
        "depth",
        [&](gpu::PassBuilder& pass, DepthPass& data) {
            data.depth_buffer = pass.read(graph.find("depth_buffer"));
            const gpu::TextureDesc& desc = graph.desc(data.depth_buffer);
            data.depth = pass.create("depth", {desc.width, desc.height, gpu::Format::r32f});
            graph.publish("depth", data.depth);
            pass.depends_on(world.resource<View>().key(), render.shaders->generation());
        },
        [&world, &render](const DepthPass& data, gpu::PassContext& pass) {
            const gpu::TextureDesc& desc = pass.desc(data.depth);
            render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
            render.backend->framebuffer({pass.texture(data.depth)}).bind();
            render.draw_full_screen("surface/depth.frag", {.viewport = {0, 0, desc.width, desc.height}},
                                    {pass.texture(data.depth_buffer)});
        });
}

struct EncodePass {
    gpu::TextureHandle color, picture;
};

/// `picture` is what a screen or a PNG file shows. Colour that is already drawn into an sRGB target is the picture.
void declare_picture(RenderContext& render) {
    gpu::FrameGraph& graph = render.graph;
    const gpu::TextureHandle color = graph.find("color");
    const gpu::TextureDesc desc = graph.desc(color);
    if (desc.format == gpu::Format::srgb8_alpha8) {
        graph.publish("picture", color);
        return;
    }
    graph.add_pass<EncodePass>(
        "encode",
        [&](gpu::PassBuilder& pass, EncodePass& data) {
            data.color = pass.read(color);
            data.picture = pass.create("picture", {desc.width, desc.height, gpu::Format::srgb8_alpha8});
            graph.publish("picture", data.picture);
            pass.depends_on(render.shaders->generation());
        },
        [&render](const EncodePass& data, gpu::PassContext& pass) {
            const gpu::TextureDesc& size = pass.desc(data.picture);
            render.backend->framebuffer({pass.texture(data.picture)}).bind();
            render.draw_full_screen("compose/encode.frag",
                                    {.viewport = {0, 0, size.width, size.height}, .srgb_write = true},
                                    {pass.texture(data.color)});
        });
}

void declare_passes(World& world) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    declare_overlay(world, render);
    declare_depth(world, render);
    declare_picture(render);
}

} // namespace

void register_compose(App& app) {
    app.add_component<Compose>();
    if (!app.world().find_resource<LineLayer>()) app.world().set_resource(LineLayer{});
    frame_requests(app.world())
        .known.push_back({"depth", "metres from the plane of the eye; 1e10 where nothing is drawn", {"Z"}});
    app.add_system(Stage::render, "compose.blank", declare_blank)
        .after("surface.passes")
        .after("picture.pass")
        .after("velocity.pass")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .after("abstracted_lines.pass")
        .after("implicit_brush.pass")
        .after("shade_strokes.pass")
        .before("paper.pass");
    app.add_system(Stage::render, "compose.passes", declare_passes)
        .after("compose.blank")
        .after("surface.passes")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .after("abstracted_lines.pass")
        .after("implicit_brush.pass")
        .after("shade_strokes.pass")
        .after("paper.pass");
}

} // namespace hachure
