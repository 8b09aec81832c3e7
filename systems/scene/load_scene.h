#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/systems/scene/scene_faults.h>

#include <glm/vec3.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure {

/// How a scene is loaded.
struct SceneOptions {
    std::string style;          ///< a name or a preset file, in place of the scene's own; empty: the scene's own
    std::string fallback_style; ///< where there is neither; empty for none
};

/// What load_scene put into the world.
struct LoadedScene {
    std::vector<Entity> roots;
    std::vector<std::string> warnings; ///< one line each, with the file and the place in it
    bool has_camera = false;           ///< one that is active
    bool has_light = false;
    std::vector<glm::vec3> points; ///< what a camera must see, as SpawnedModel::points; of many models the corners of
                                   ///< their boxes; none where the scene has a camera
};

/// Adds a scene file (docs/scenes.md) to the world of `app`, which stays as it was where the file has a fault: all
/// entities with their models, the resource SceneDocument, and the Spawner for files below the scene's folder. Throws
/// Error that names the fault by line and column.
LoadedScene load_scene(App& app, const std::filesystem::path& file, const SceneOptions& options = {});

/// All that is wrong with a scene file and those that it refers to, and what is odd. Nothing is thrown, and no world is
/// touched but that of `app`, which is for nothing else after it.
struct SceneFindings {
    std::vector<SceneFault> faults;
    std::vector<std::string> warnings;
};
[[nodiscard]] SceneFindings inspect_scene(App& app, const std::filesystem::path& file);

} // namespace hachure
