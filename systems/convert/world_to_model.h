#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/systems/styles/style.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace hachure {

/// What of a world becomes a model.
struct WorldToModel {
    std::span<const Entity> roots; ///< with all below them
    const Style* style = nullptr;  ///< that surfaces and cameras carry; what they carry of it is not said again
    std::filesystem::path scene;   ///< the file that the world was read from: paths in its parts are relative to it
    std::filesystem::path output;  ///< the file that is to be written: paths in it are relative to it
};

/// Makes one model of the entities of a scene: a node for each, with its name and transform; of what stands below a
/// SceneReference the meshes, materials, skins and clips of that file, read once, each instance with nodes of its own;
/// cameras and lights. All other components that are reflected, scene parts, and what scene files say that is not known
/// here, become extras (assets/gltf_extras.h) with the fields that differ from their defaults, or from the style.
///
/// A file has one place for what plays clips: when one model of the world plays, what it plays becomes the scene's
/// extras; when several do, it stays with their nodes, which play nothing, and a warning says so. Clips whose name is
/// taken are called after their model's entity too, "Fox/Run". Throws Error for files that can't be read.
[[nodiscard]] assets::Model world_to_model(const App& app, const WorldToModel& what,
                                           std::vector<std::string>& warnings);

} // namespace hachure
