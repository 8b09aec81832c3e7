#pragma once

#include <hachure/runtime/ecs/world.h>

#include <filesystem>
#include <functional>
#include <string>

namespace hachure {

/// What to add to the world while it runs.
struct SpawnRequest {
    std::string what; ///< a model or scene file, relative to the scene's folder and inside it; or, when it has no dot
                      ///< in it, the name (or path of names) of an entity to copy with all below it
    Entity parent;    ///< null for none
    std::string name; ///< of the new root; empty keeps the file's or the copied entity's
};

/// Resource: how systems make entities from files and from other entities, without knowing how either is read. Files
/// are read once and copied after that. Set by whoever loads scenes.
struct Spawner {
    /// Returns the root of what was made. Throws Error for files that can't be used, and for names that nobody has.
    /// Call it from systems that take World&.
    std::function<Entity(World& world, const SpawnRequest& request)> spawn;
};

} // namespace hachure
