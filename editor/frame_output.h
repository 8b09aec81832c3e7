#pragma once

#include <hachure/editor/background_queue.h>
#include <hachure/editor/render_outputs.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/scene/renderer.h>

#include <memory>
#include <string>
#include <vector>

namespace hachure {

/// Takes drawn frames to their files: reads them back and lets another thread encode and write them while the next ones
/// are drawn. The files do not depend on that.
class FrameOutput {
public:
    /// Asks the renderer, which must outlive this, for the AOVs that are written. Throws Error when a film can't be, or
    /// an SVG file would have nothing to hold.
    FrameOutput(App& app, Renderer& renderer, const RenderOutputs& outputs, const FramePlan& plan);

    /// Hands on what the renderer drew last, as frame `number`. Waits while three frames are under way. Throws Error,
    /// also for earlier frames.
    void take(std::int64_t number);

    /// Waits until all is written; films are in their places then. Throws Error.
    void finish();

private:
    /// One of the things that are written of every frame.
    struct Target {
        std::string aov; ///< empty: the picture
        std::unique_ptr<assets::FrameSequenceWriter> writer;
    };

    App* app_;
    Renderer* renderer_;
    std::filesystem::path drawing_; ///< an SVG file, instead of a picture; empty for none
    std::vector<Target> targets_;
    BackgroundQueue queue_; // ends before the writers that it uses do
};

} // namespace hachure
