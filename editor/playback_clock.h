#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/model.h>

#include <filesystem>
#include <string>

/// Where the command line and time meet: the one place to connect what moves with time.
namespace hachure {

/// Makes the next frame of `app` show the moment `seconds` (0 or more, finite, not before that of the last frame),
/// whichever frames came before it. Returns how long after the last frame that is, for Renderer::render_frame.
[[nodiscard]] double seek(const App& app, double seconds);

/// Throws Error when `clip` (`--clip`) is not empty and `model`, which was read from `file`, has no clip of that name.
void check_clip(const assets::Model& model, const std::filesystem::path& file, const std::string& clip);

} // namespace hachure
