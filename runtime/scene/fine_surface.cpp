#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/fine_surface.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>

#include <array>
#include <string>

namespace hachure {
namespace {

const gpu::Framebuffer& framebuffer_of(RenderContext& render, gpu::PassContext& pass, const FineSurface& surface) {
    const std::uint32_t depth = pass.texture(surface.depth_buffer);
    return surface.normals ? render.backend->framebuffer({pass.texture(surface.normals)}, depth)
                           : render.backend->framebuffer({}, depth);
}

void draw_fine_surface(const World& world, RenderContext& render, const gpu::Framebuffer& target,
                       const gpu::Rect& drawn, bool normals) {
    const gpu::Rect whole{0, 0, target.width(), target.height()};
    target.bind();
    gpu::apply({.viewport = whole, .depth_test = gpu::DepthTest::always, .depth_write = true});
    if (normals) target.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    target.clear_depth(0.0f);
    draw_all_surfaces(world, render, {.fragment = normals ? "surface/fine_normal.frag" : "surface/fine_depth.frag"},
                      whole, drawn);
}

} // namespace

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

FineSurface declare_fine_surface(World& world, const FineSurfaceRequest& request) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View fine = fine_view(world.resource<View>(), request.samples);
    const gpu::Rect drawn = fine_rect(request.rect, request.samples);
    const std::string name(request.pass);
    return render.graph.add_pass<FineSurface>(
        name,
        [&](gpu::PassBuilder& pass, FineSurface& data) {
            data.depth_buffer = pass.create(name + "_depth", {fine.width, fine.height, gpu::Format::depth32f});
            if (request.normals)
                data.normals = pass.create(name + "_normals", {fine.width, fine.height, gpu::Format::rgba16f});
            pass.depends_on(world.resource<DrawList>().key, render.shaders->generation());
            pass.draws_in(drawn);
        },
        [&world, &render, drawn, normals = request.normals](const FineSurface& data, gpu::PassContext& pass) {
            draw_fine_surface(world, render, framebuffer_of(render, pass, data), drawn, normals);
        });
}

} // namespace hachure
