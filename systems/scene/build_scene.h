#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/systems/scene/scene_cache.h>
#include <hachure/systems/scene/scene_faults.h>
#include <hachure/systems/scene/scene_fields.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hachure {

/// What a scene may grow to, with all that it refers to.
inline constexpr std::size_t max_scene_entities = 2'000'000;
inline constexpr int max_scene_depth = 32; ///< scenes within scenes

/// One use of a scene file: the file that was asked for, or a reference to another one.
struct SceneScope {
    std::shared_ptr<const SceneFile> file;
    Entity root;    ///< that refers to it; null for the outermost
    int outer = -1; ///< index of the scope that refers to it
};

/// An entity that a scene file tells of, and what it says.
struct ScenePiece {
    Entity entity;
    const nlohmann::json* value = nullptr;
    std::string pointer; ///< of the value in the root of the scope's file
    std::uint32_t scope = 0;
};

/// The tree of a scene: all entities, with their names and those of the models and scenes that stand below them, and
/// without what is said of them.
struct BuiltScene {
    std::vector<SceneScope> scopes; ///< an outer one before its inner ones
    std::vector<ScenePiece> pieces; ///< an entity before those below it
    std::vector<Entity> roots;
    std::vector<std::pair<Entity, std::filesystem::path>> models; ///< uses of models
};

/// Makes the entities of `file` in the world, and lists them in `built`, which is empty before. When it throws, `built`
/// has all roots that were made by then.
void build_scene(World& world, SceneCache& cache, const SceneTypes& types, std::shared_ptr<const SceneFile> file,
                 SceneFaults& faults, BuiltScene& built);

} // namespace hachure
