#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/frame_graph_stats.h>

#include <span>
#include <string>
#include <string_view>

namespace hachure {

/// Draws an App's world: runs its systems, then the passes that they declared. Make it before registering capabilities
/// that draw; the context must outlive it and be current on this thread whenever it is used.
class Renderer {
public:
    /// Gives the world its RenderContext and FrameRequests.
    Renderer(App& app, gpu::Context& context);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Makes each frame hold the AOV from now on. Throws Error when no capability can make it, naming those there are.
    void request_aov(std::string_view name);

    /// One frame, `delta_seconds` (0 or more) after the one before.
    void render_frame(double delta_seconds = 0);

    /// The same without drawing: every system runs, no pass does. Later frames are as if it had been drawn; there is no
    /// picture of it.
    void skip_frame(double delta_seconds = 0);

    /// The picture of the last frame: u8, RGB, sRGB, as PNG files have it. Waits for the GPU.
    [[nodiscard]] assets::Image read_picture();

    /// A requested AOV of the last frame, f32. Waits for the GPU.
    [[nodiscard]] assets::Image read_aov(std::string_view name);

    /// Copies the picture of the last frame to the context's window and shows it.
    void present();

    /// What each pass of the last frame did; waits for the GPU's timers.
    [[nodiscard]] std::span<const gpu::PassStats> pass_stats();
    [[nodiscard]] gpu::FrameGraphMemory memory() const;

    /// Waits until the GPU is idle.
    void finish();

private:
    /// Runs the systems, which declare the frame's passes.
    void declare_frame(double delta_seconds);

    App* app_;
};

} // namespace hachure
