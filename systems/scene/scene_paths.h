#pragma once

#include <hachure/components/name_index.h>
#include <hachure/runtime/ecs/world.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hachure {

class NamesBelow;

/// How a scene file names things: files by their way from its folder, entities by paths of names.
class ScenePaths {
public:
    ScenePaths(const World& world, const std::filesystem::path& folder);
    ~ScenePaths();

    /// The path from the folder.
    [[nodiscard]] std::string relative(const std::filesystem::path& file) const;

    /// The shortest path of names by which the entity is found first in the whole world; nothing where none does.
    [[nodiscard]] std::optional<std::string> path_to(Entity entity);

    /// The same among what stands below `owner`.
    [[nodiscard]] std::optional<std::string> path_below(Entity owner, Entity entity);

    /// What messages call the entity.
    [[nodiscard]] std::string label(Entity entity) const;

private:
    const World& world_;
    std::filesystem::path folder_; ///< absolute
    std::optional<NameIndex> index_;
    std::map<Entity, NamesBelow> below_;
};

} // namespace hachure
