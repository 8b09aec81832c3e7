#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/weight_map.h>

#include <array>
#include <vector>

namespace hachure {
namespace {

struct WeightPass {
    std::vector<gpu::TextureHandle> inks;
    gpu::TextureHandle weight;
};

} // namespace

void declare_weight_map(World& world, std::span<const BrushInk> inks) {
    if (!world.resource<FrameRequests>().wants("brush_weight")) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const std::vector<BrushInk> drawn(inks.begin(), inks.end());
    render.graph.add_pass<WeightPass>(
        "brush_weight",
        [&](gpu::PassBuilder& pass, WeightPass& data) {
            for (const BrushInk& ink : drawn) {
                data.inks.push_back(pass.read(ink.ink));
                pass.depends_on(ink.rect);
            }
            data.weight = pass.create("brush_weight", {view.width, view.height, gpu::Format::r32f});
            render.graph.publish("brush_weight", data.weight);
            pass.depends_on(render.shaders->generation());
        },
        [&render, drawn](const WeightPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.weight)});
            target.bind();
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
            target.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
            for (std::size_t i = 0; i < drawn.size(); ++i)
                render.draw_full_screen("implicit_brush/weight.frag",
                                        {.viewport = {0, 0, target.width(), target.height()},
                                         .scissor = drawn[i].rect,
                                         .blend = gpu::Blend::max},
                                        {pass.texture(data.inks[i])});
        });
}

} // namespace hachure
