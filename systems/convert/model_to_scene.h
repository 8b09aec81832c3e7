#pragma once

#include <hachure/runtime/app/app.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure {

/// Makes a scene file of one entity that refers to a model, called as the file. What the model's extras say is said
/// again where it can be edited: of the root beside the model, of surfaces that all say the same in a look, of others
/// in overrides. Meshes, clips, cameras and lights stay in the model. `output` is the file that the text is for: paths
/// are relative to it. `app` is for nothing else after it. Throws Error for a model that can't be read.
[[nodiscard]] std::string model_to_scene(App& app, const std::filesystem::path& model,
                                         const std::filesystem::path& output, std::vector<std::string>& warnings);

} // namespace hachure
