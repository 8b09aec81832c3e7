#pragma once

#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/frame_graph_gl.h>
#include <hachure/runtime/gpu/full_screen.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/gpu_meshes.h>
#include <hachure/runtime/scene/view_uniforms.h>

#include <initializer_list>
#include <memory>
#include <string_view>

namespace hachure {

/// The GPU side of a world: everything that render systems draw with. A resource, made by Renderer.
/// Its context belongs to one thread: systems that use it take World&, which keeps them on the thread that runs frames.
struct RenderContext {
    explicit RenderContext(gpu::Context& gpu_context)
        : context(&gpu_context), backend(std::make_unique<gpu::GlFrameGraphBackend>()),
          shaders(std::make_unique<gpu::ShaderLibrary>()), graph(*backend) {}

    gpu::Context* context;
    std::unique_ptr<gpu::GlFrameGraphBackend> backend;
    std::unique_ptr<gpu::ShaderLibrary> shaders;
    gpu::FrameGraph graph;
    gpu::FullScreen full_screen;
    GpuMeshes meshes;
    ViewUniforms view_uniforms;

    /// Draws `fragment` over every pixel of the state's viewport and scissor with the current framebuffer; the textures
    /// are bound to units 0, 1, ...
    void draw_full_screen(std::string_view fragment, const gpu::DrawState& state,
                          std::initializer_list<std::uint32_t> textures);
};

} // namespace hachure
