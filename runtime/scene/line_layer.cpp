#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>

#include <array>

namespace hachure {

LineTarget write_line_layer(World& world, gpu::PassBuilder& pass) {
    gpu::FrameGraph& graph = world.resource_mutable<RenderContext>().graph;
    const View& view = world.resource<View>();
    const gpu::TextureHandle below = graph.find("line_layer");
    const LineTarget target{
        below ? pass.write(below) : pass.create("line_layer", {view.width, view.height, gpu::Format::rgba16f}), !below};
    graph.publish("line_layer", target.layer);
    pass.depends_on(world.resource<LineLayer>().rect());
    return target;
}

/// Compose looks at the rectangle of all lines alone, who asks for the layer as an AOV at all of it.
void bind_line_layer(World& world, const gpu::PassContext& pass, const LineTarget& target) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const gpu::Framebuffer& layer = render.backend->framebuffer({pass.texture(target.layer)});
    layer.bind();
    if (!target.first) return;
    gpu::DrawState state{.viewport = {0, 0, layer.width(), layer.height()}};
    if (world.resource<FrameRequests>().aovs.empty()) state.scissor = world.resource<LineLayer>().rect();
    gpu::apply(state);
    layer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
}

} // namespace hachure
