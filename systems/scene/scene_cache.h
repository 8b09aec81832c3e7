#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/scene/scene_file.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hachure {

/// The files that the scenes of one world refer to, each read once.
class SceneCache {
public:
    struct CachedModel {
        assets::Model model;
        StoredModel stored;
        std::vector<std::string> warnings; ///< of reading it and of spawning it first, with its file
        bool spawned = false;
        Entity prototype; ///< while a scene is made: a copy of the model that nobody changes, or null
    };

    /// Throws Error.
    CachedModel& model(const std::filesystem::path& file);

    /// Throws Error.
    std::shared_ptr<const SceneFile> scene(const std::filesystem::path& file);

    /// Spawns a model; what it adds to `world` that is no part of the tree is added the first time only.
    SpawnedModel spawn(World& world, const std::filesystem::path& file);

    /// The same where many copies are likely: all but the first few are copied from a prototype.
    Entity spawn_copy(World& world, const std::filesystem::path& file);

    /// Destroys the prototypes, and forgets what only the first spawning of a model reads.
    void finish(World& world);

private:
    std::map<std::string, CachedModel> models_; ///< by canonical path
    std::map<std::string, std::shared_ptr<const SceneFile>> scenes_;
};

/// A path that is the same for all ways to say it.
[[nodiscard]] std::string canonical_path(const std::filesystem::path& file);

} // namespace hachure
