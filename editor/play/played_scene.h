#pragma once

#include <hachure/editor/play/play_document.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>

#include <cstdint>
#include <span>
#include <string>

namespace hachure::play {

/// What a test plays, opened: a world with all capabilities, stepped frame by frame from frame 0.
class PlayedScene {
public:
    /// Opens the test's scene, with `more_sets` after its own assignments. The context is current and outlives it; the
    /// document, too. Throws Error.
    PlayedScene(gpu::Context& context, const PlayDocument& play, std::span<const std::string> more_sets = {},
                bool count_allocations = false);

    /// Plays the next frame, drawn or not.
    void step(bool draw);

    /// The same with these events instead of the test's own.
    void step(bool draw, std::span<const InputEvent> events);

    [[nodiscard]] std::int64_t next_frame() const { return next_; }
    [[nodiscard]] App& app() { return app_; }
    [[nodiscard]] Renderer& renderer() { return renderer_; }

private:
    const PlayDocument* play_;
    App app_;
    Renderer renderer_;
    std::int64_t next_ = 0;
};

} // namespace hachure::play
