#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/program.h>
#include <hachure/runtime/gpu/shader_source.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

struct RenderContext;

/// The textures that surfaces are drawn into. `color` and `depth_buffer` always exist; `normal`, `object_id`
/// and `code` only when something in the frame wants them. `code` is for passes that look at every pixel's neighbours:
/// object id and normal in one texel of 8 bytes (shaders/surface/surface_code.glsl), published as `surface_code`.
struct SurfaceTargets {
    gpu::TextureHandle color, depth_buffer, normal, object_id, code;

    /// Finds the published targets and declares that `pass` writes onto them; publishes the new versions.
    [[nodiscard]] static SurfaceTargets write(gpu::FrameGraph& graph, gpu::PassBuilder& pass);
};

/// How a capability shades the items it has claimed in the DrawList.
struct SurfaceShading {
    std::string_view name;     ///< as in DrawClaims
    std::string_view fragment; ///< below shaders/; includes surface/surface.glsl and calls write_surface()
    /// Adds the defines that the item needs and sets its uniforms; either may be empty.
    std::function<void(Entity, std::vector<gpu::ShaderDefine>&)> defines = {};
    std::function<void(Entity, gpu::Program&)> uniforms = {};
    std::string_view vertex = "surface/surface.vert"; ///< another one includes surface/vertex.glsl
    /// Binds what else the shaders read, before each of the item's draw calls: textures from unit `first_free_unit` on,
    /// storage buffers. May be empty.
    std::function<void(const DrawItem&)> bind = {};
    /// Another vertex array to draw the item with: same indices in the same order, attribute locations 0 to 5 as those
    /// of GpuMesh, its own from 6 on. Null, or an empty function, for the item's own.
    std::function<const gpu::VertexArray*(const DrawItem&)> vertex_array = {};

    static constexpr unsigned first_free_unit = 2; ///< units 0 and 1 hold the material's textures
};

/// Draws every item of the world's DrawList that `shading` has claimed (DrawClaims) into `targets`, from within a pass.
void draw_surfaces(const World& world, RenderContext& render, gpu::PassContext& pass, const SurfaceTargets& targets,
                   const SurfaceShading& shading);

/// Draws every item of the DrawList, whoever shades it, with one fragment shader (as SurfaceShading::fragment; what it
/// writes is linear) into the framebuffer that is bound, at any viewport: for what another resolution, or another
/// buffer of all surfaces, is needed for.
void draw_all_surfaces(const World& world, RenderContext& render, std::string_view fragment, const gpu::Rect& viewport);

/// The same with all that a shading can say, confined to `scissor`.
void draw_all_surfaces(const World& world, RenderContext& render, const SurfaceShading& shading,
                       const gpu::Rect& viewport, const gpu::Rect& scissor);

/// Declares the pass `shading.name`, which draws the claimed items and depends on `key` (what the shading itself
/// depends on; view, lights, items and shaders are counted in). Without claimed items there is no pass.
void add_surface_pass(World& world, const SurfaceShading& shading, std::uint64_t key);

} // namespace hachure
