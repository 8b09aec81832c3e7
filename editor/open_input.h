#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/view.h>

#include <filesystem>
#include <optional>
#include <string>

namespace hachure {

/// How an input is opened.
struct OpenOptions {
    std::string style;               ///< a name or a preset file; empty: the scene's own, else gooch, or lines
    std::optional<std::string> clip; ///< of a model: as load_model has it. A scene says itself what it plays
};

/// Puts a model, a scene (".scene.json"), an image, a video or numbered images (shot.####.exr), told by the extension,
/// into the app's world, with its style, a camera that frames it and the default light where the file has none. Sets
/// the Spawner for files beside it. Needs no GL context. Warnings go to stderr. Throws Error for what is wrong with the
/// files, for a clip of anything but a model, and for a style that draws surfaces alone where there is an image or a
/// video.
void open_input(App& app, const std::filesystem::path& input, Canvas canvas, const OpenOptions& options = {});

/// Whether a file is an image, a video or numbered images by its name.
[[nodiscard]] bool is_picture_name(const std::filesystem::path& input);

/// The size of an image, a video, or the first of numbered images, from its header. Throws Error.
[[nodiscard]] Canvas picture_size(const std::filesystem::path& input);

} // namespace hachure
