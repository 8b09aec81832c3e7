#pragma once

#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/frame_graph_gl.h>
#include <hachure/runtime/gpu/full_screen.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/gpu_meshes.h>
#include <hachure/runtime/scene/view_uniforms.h>

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// A named float buffer of the frame that can be asked for (`--aov NAME=FILE.exr`).
struct AovInfo {
    std::string name;                       ///< also the name of the frame-graph texture that holds it
    std::string doc;                        ///< one line: what it is, unit, value where nothing is drawn
    std::vector<std::string> channel_names; ///< of the EXR file, in the order of the texture's channels
};

/// What the parts of a frame ask of each other. A resource.
struct FrameRequests {
    std::vector<AovInfo> known;  ///< every AOV that a registered capability can make
    std::set<std::string, std::less<>> aovs; ///< what the program wants, every frame, by name
    std::set<std::string, std::less<>> textures; ///< what systems of stage `material` want of this frame, by name

    [[nodiscard]] bool wants(std::string_view name) const { return aovs.contains(name) || textures.contains(name); }
};

/// The GPU side of a world: everything that render systems draw with. A resource, made by Renderer.
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
