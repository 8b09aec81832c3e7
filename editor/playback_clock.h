#pragma once

#include <hachure/runtime/app/app.h>

/// Where the command line and time meet: the one place to connect what moves with time.
namespace hachure {

/// Makes the next frame of `app` show the moment `seconds` (0 or more, finite, not before that of the last frame),
/// whichever frames came before it. Returns how long after the last frame that is, for Renderer::render_frame.
[[nodiscard]] double seek(const App& app, double seconds);

/// Whether what a frame shows depends on the frames before it: state builds up where an entity carries a script, a
/// timeline, shade strokes, or a brush whose noise motion carries along. Such inputs are stepped from frame 0 at the
/// frame rate; all else may jump to any moment.
[[nodiscard]] bool needs_stepping(const App& app);

} // namespace hachure
