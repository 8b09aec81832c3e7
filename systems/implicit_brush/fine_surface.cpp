#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/systems/implicit_brush/fine_surface.h>

#include <array>

namespace hachure {

View fine_view(const View& view, int samples) {
    View fine = view;
    fine.width *= samples;
    fine.height *= samples;
    fine.pixel_size /= static_cast<float>(samples);
    return fine;
}

gpu::Rect fine_rect(const gpu::Rect& rect, int samples) {
    return {samples * rect.x, samples * rect.y, samples * rect.width, samples * rect.height};
}

FineSurface declare_fine_surface(World& world, int samples, const gpu::Rect& rect) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View fine = fine_view(world.resource<View>(), samples);
    const gpu::Rect drawn = fine_rect(rect, samples);
    return render.graph.add_pass<FineSurface>(
        "brush_fine_surface",
        [&](gpu::PassBuilder& pass, FineSurface& data) {
            data.depth_buffer = pass.create("brush_fine_depth", {fine.width, fine.height, gpu::Format::depth32f});
            data.normals = pass.create("brush_fine_normals", {fine.width, fine.height, gpu::Format::rgba16f});
            pass.depends_on(world.resource<DrawList>().key, render.shaders->generation());
            pass.draws_in(drawn);
        },
        [&world, &render, drawn](const FineSurface& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target =
                render.backend->framebuffer({pass.texture(data.normals)}, pass.texture(data.depth_buffer));
            const gpu::Rect whole{0, 0, target.width(), target.height()};
            target.bind();
            gpu::apply({.viewport = whole, .depth_test = gpu::DepthTest::always, .depth_write = true});
            target.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
            target.clear_depth(0.0f);
            draw_all_surfaces(world, render, {.fragment = "implicit_brush/fine_normal.frag"}, whole, drawn);
        });
}

} // namespace hachure
