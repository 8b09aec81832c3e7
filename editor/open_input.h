#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/view.h>

#include <filesystem>
#include <optional>
#include <string>

namespace hachure {

/// How an input is opened.
struct OpenOptions {
    std::string style;               ///< a name or a preset file; empty: the scene's own, else gooch
    std::optional<std::string> clip; ///< of a model: as load_model has it. A scene says itself what it plays
};

/// Puts a model or a scene, told by its extension (".scene.json"), into the app's world, with its style, a camera that
/// frames it and the default light where the file has none. Sets the Spawner for files beside it. Needs no GL context.
/// Warnings go to stderr. Throws Error for what is wrong with the files, and for a clip of a scene.
void open_input(App& app, const std::filesystem::path& input, Canvas canvas, const OpenOptions& options = {});

} // namespace hachure
