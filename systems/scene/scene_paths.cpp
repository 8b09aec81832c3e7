#include <hachure/components/name.h>
#include <hachure/systems/scene/scene_names.h>
#include <hachure/systems/scene/scene_paths.h>

namespace hachure {
namespace {

namespace fs = std::filesystem;

/// The shortest path of names, from the entity up to and without `top`, that `find` answers with the entity.
template <class Find>
std::optional<std::string> shortest(const World& world, Entity entity, Entity top, const Find& find) {
    std::string path;
    for (Entity at = entity; at && at != top; at = world.parent(at)) {
        const Name* name = world.find<Name>(at);
        if (!name) return {};
        path = path.empty() ? name->text : name->text + "/" + path;
        if (find(path) == entity) return path;
    }
    return {};
}

} // namespace

ScenePaths::ScenePaths(const World& world, const fs::path& folder)
    : world_(world), folder_(fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal()) {}

ScenePaths::~ScenePaths() = default;

std::string ScenePaths::relative(const fs::path& file) const {
    const fs::path way = fs::absolute(file).lexically_normal().lexically_relative(folder_);
    return way.empty() ? file.generic_string() : way.generic_string();
}

std::optional<std::string> ScenePaths::path_to(Entity entity) {
    if (!index_) index_.emplace().update(world_);
    return shortest(world_, entity, Entity::null, [&](const std::string& path) { return index_->find(world_, path); });
}

std::optional<std::string> ScenePaths::path_below(Entity owner, Entity entity) {
    const NamesBelow& names = below_.try_emplace(owner, world_, owner).first->second;
    return shortest(world_, entity, owner, [&](const std::string& path) { return names.find(world_, path); });
}

std::string ScenePaths::label(Entity entity) const {
    const Name* name = world_.find<Name>(entity);
    return name ? "entity '" + name->text + "'" : "entity " + to_string(entity);
}

} // namespace hachure
