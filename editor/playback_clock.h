#pragma once

#include <hachure/runtime/app/app.h>

/// Where the command line and time meet: the one place to connect what moves with time.
namespace hachure {

/// Makes the next frame of `app` show the moment `seconds` (0 or more, finite, not before that of the last frame),
/// whichever frames came before it. Returns how long after the last frame that is, for Renderer::render_frame.
[[nodiscard]] double seek(const App& app, double seconds);

} // namespace hachure
