#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/fine_surface.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/shade_strokes/component_settings.h>
#include <hachure/systems/shade_strokes/shade_passes.h>

#include <algorithm>
#include <array>
#include <span>

namespace hachure {
namespace {

struct ShadePass {
    gpu::TextureHandle depth, coverage;
    LineTarget lines;
};

bool wants_coverage(const FrameRequests& requests) {
    return requests.wants("shade_coverage") || requests.wants("stroke_coverage");
}

void clear_coverage(RenderContext& render, std::uint32_t texture) {
    const gpu::Framebuffer& target = render.backend->framebuffer({texture});
    target.bind();
    gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
    target.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
}

} // namespace

void ShadePasses::declare(World& world) {
    const ShadeFrame& frame = world.resource<ShadeFrame>();
    forget_all_but(frame);
    if (frame.surfaces.empty() || frame.rect.width <= 0 || frame.rect.height <= 0) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const FineSurface fine = declare_fine_surface(
        world, {.pass = "shade_fine", .samples = fine_samples(view.width, view.height), .rect = frame.rect});
    render.graph.add_pass<ShadePass>(
        "shade_strokes",
        [&](gpu::PassBuilder& pass, ShadePass& data) {
            data.depth = pass.read(fine.depth_buffer);
            data.lines = write_line_layer(world, pass);
            if (wants_coverage(world.resource<FrameRequests>())) {
                data.coverage = pass.create("shade_coverage", {view.width, view.height, gpu::Format::r16f});
                render.graph.publish("shade_coverage", data.coverage);
            }
            pass.depends_on(world.resource<DrawList>().key, view.key(), frame.key, render.shaders->generation());
            pass.draws_in(frame.rect);
        },
        [this, &world, &render](const ShadePass& data, gpu::PassContext& pass) {
            const gpu::Rect rect = world.resource<ShadeFrame>().rect;
            bind_line_layer(world, pass, data.lines);
            if (data.coverage) {
                clear_coverage(render, pass.texture(data.coverage));
                render.backend->framebuffer({pass.texture(data.lines.layer), pass.texture(data.coverage)}).bind();
            }
            const gpu::TextureDesc& desc = pass.desc(data.lines.layer);
            gpu::apply(
                {.viewport = {0, 0, desc.width, desc.height}, .scissor = rect, .blend = gpu::Blend::premultiplied});
            draw(world, render.backend->texture(pass.texture(data.depth)), bool(data.coverage));
        });
}

void ShadePasses::draw(World& world, const gpu::Texture& depth, bool coverage) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const ShadeFrame& frame = world.resource<ShadeFrame>();
    const DrawList& list = world.resource<DrawList>();
    const MeshStore& store = world.resource<MeshStore>();
    if (!patterns_) patterns_.emplace();
    const View& view = world.resource<View>();
    render.view_uniforms.bind(view, world.resource<LightList>());
    for (const ShadeSurface& surface : frame.surfaces) {
        const DrawItem& item = list.items[surface.item];
        ShadeBuffers& buffers = buffers_[surface.entity];
        buffers.update(*surface.chains, surface.narrowing, surface.narrowing_version);
        const ShadeStrokeDraw strokes{.shaders = render.shaders.get(),
                                      .patterns = &*patterns_,
                                      .buffers = &buffers,
                                      .positions = &render.meshes.positions(store, item),
                                      .indices = &indices_of(world, item.mesh),
                                      .triangles = static_cast<std::uint32_t>(store.mesh(item.mesh).indices.size() / 3),
                                      .world_from_mesh = surface.world_from_mesh,
                                      .size = surface.mesh->size,
                                      .style = surface.style,
                                      .samples = fine_samples(view.width, view.height),
                                      .tick = flicker_tick(surface.style, frame.time)};
        strokes.find();
        strokes.draw(depth, coverage);
    }
}

/// GpuMesh has its triangles in another order.
const gpu::Buffer& ShadePasses::indices_of(const World& world, std::uint32_t mesh) {
    gpu::Buffer& buffer = indices_[mesh];
    if (!buffer) {
        const std::span<const std::uint32_t> indices(world.resource<MeshStore>().mesh(mesh).indices);
        buffer = gpu::Buffer(indices, "shade triangles");
    }
    return buffer;
}

void ShadePasses::forget_all_but(const ShadeFrame& frame) {
    std::erase_if(buffers_, [&](const auto& entry) {
        return std::ranges::find(frame.surfaces, entry.first, &ShadeSurface::entity) == frame.surfaces.end();
    });
}

ShadeUploads ShadePasses::uploads() const {
    ShadeUploads sum;
    for (const auto& [entity, buffers] : buffers_) {
        sum.calls += buffers.uploads().calls;
        sum.bytes += buffers.uploads().bytes;
    }
    return sum;
}

} // namespace hachure
