#include <hachure/components/name.h>
#include <hachure/systems/scene/scene_names.h>

#include <algorithm>

namespace hachure {
namespace {

/// Whether the names of `entity` and its ancestors below `root`, as many as it takes, spell `path`.
bool is_called(const World& world, Entity root, Entity entity, std::string_view path) {
    for (; entity && entity != root; entity = world.parent(entity)) {
        const Name* name = world.find<Name>(entity);
        if (!name || !path.ends_with(name->text)) return false;
        path.remove_suffix(name->text.size());
        if (path.empty()) return true;
        if (path.back() != '/') return false;
        path.remove_suffix(1);
    }
    return false;
}

bool at_or_below(const World& world, Entity entity, Entity scope) {
    for (; entity; entity = world.parent(entity))
        if (entity == scope) return true;
    return false;
}

} // namespace

NamesBelow::NamesBelow(const World& world, Entity root) : root_(root), below_(world.descendants(root)) {
    for (std::size_t i = 0; i < below_.size(); ++i)
        if (const Name* name = world.find<Name>(below_[i])) by_name_.emplace(name->text, i);
}

Entity NamesBelow::find(const World& world, std::string_view path) const {
    std::size_t best = below_.size();
    for (std::size_t begin = 0;; ++begin) {
        const auto [first, last] = by_name_.equal_range(std::string(path.substr(begin)));
        for (auto entry = first; entry != last; ++entry)
            if (entry->second < best && is_called(world, root_, below_[entry->second], path)) best = entry->second;
        begin = path.find('/', begin);
        if (begin == path.npos) break;
    }
    return best < below_.size() ? below_[best] : Entity::null;
}

Entity find_within(const NameIndex& index, const World& world, std::string_view path, Entity scope) {
    const std::vector<Entity> all = index.find_all(world, path);
    if (scope) {
        const auto inside = std::ranges::find_if(all, [&](Entity e) { return at_or_below(world, e, scope); });
        if (inside != all.end()) return *inside;
    }
    return all.empty() ? Entity::null : all.front();
}

} // namespace hachure
