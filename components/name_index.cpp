#include <hachure/components/name.h>
#include <hachure/components/name_index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

namespace hachure {
namespace {

/// Whether the names of `entity` and its ancestors, as many as it takes, spell `path`.
bool is_called(const World& world, Entity entity, std::string_view path) {
    for (; entity; entity = world.parent(entity)) {
        const Name* name = world.find<Name>(entity);
        if (!name || !path.ends_with(name->text)) return false;
        path.remove_suffix(name->text.size());
        if (path.empty()) return true;
        if (path.back() != '/') return false;
        path.remove_suffix(1);
    }
    return false;
}

bool is_below(const World& world, Entity entity, Entity root) {
    while ((entity = world.parent(entity)))
        if (entity == root) return true;
    return false;
}

/// Where entities stand in the tree.
class TreeOrder {
public:
    /// For `count` entities.
    TreeOrder(const World& world, std::size_t count) : world_(&world), few_(count < 32) {}

    /// The slot of the root, then the place among the siblings on each level: compares as the order of the tree does.
    std::vector<std::uint32_t> place(Entity entity) {
        std::vector<std::uint32_t> result;
        for (Entity parent; (parent = world_->parent(entity)); entity = parent)
            result.push_back(place_below(parent, entity));
        result.push_back(entity.index);
        std::ranges::reverse(result);
        return result;
    }

private:
    std::uint32_t place_below(Entity parent, Entity child) {
        const std::span<const Entity> siblings = world_->children(parent);
        // Looking through a row is faster than a table of it, unless it is looked through often.
        if (few_) return static_cast<std::uint32_t>(std::ranges::find(siblings, child) - siblings.begin());
        if (const auto known = places_.find(child); known != places_.end()) return known->second;
        // All siblings at once, as others of them are likely to be asked for.
        std::uint32_t place = 0;
        for (const Entity sibling : siblings) places_[sibling] = place++;
        return places_.at(child);
    }

    const World* world_;
    bool few_;
    std::unordered_map<Entity, std::uint32_t> places_;
};

void sort_by_tree(const World& world, std::vector<Entity>& entities) {
    if (entities.size() < 2) return;
    TreeOrder order(world, entities.size());
    std::vector<std::pair<std::vector<std::uint32_t>, Entity>> placed;
    for (const Entity entity : entities) placed.emplace_back(order.place(entity), entity);
    std::ranges::sort(placed);
    std::ranges::transform(placed, entities.begin(), [](const auto& one) { return one.second; });
}

} // namespace

void NameIndex::update(const World& world) {
    if (world.last_changed<Name>() <= seen_) return;
    // A name that is back has been removed and changed, so removals come first.
    for (const Entity entity : world.removed_since<Name>(seen_)) erase(entity);
    for (auto [entity, name] : world.query<const Name>().changed_since<Name>(seen_)) {
        erase(entity);
        insert(entity, name.text);
    }
    seen_ = world.tick() - 1; // more may happen in the current tick
}

void NameIndex::insert(Entity entity, const std::string& name) {
    const auto entry = by_name_.try_emplace(name).first;
    listings_[entity] = {&entry->first, entry->second.size()};
    entry->second.push_back(entity);
}

void NameIndex::erase(Entity entity) {
    const auto listing = listings_.find(entity);
    if (listing == listings_.end()) return;
    const auto entry = by_name_.find(*listing->second.name);
    std::vector<Entity>& list = entry->second;
    // The last takes its place; lists have no order of their own.
    list[listing->second.position] = list.back();
    listings_[list.back()].position = listing->second.position;
    list.pop_back();
    listings_.erase(entity);
    if (list.empty()) by_name_.erase(entry);
}

Entity NameIndex::find(const World& world, std::string_view path) const {
    const std::vector<Entity> all = find_all(world, path);
    return all.empty() ? Entity::null : all.front();
}

std::vector<Entity> NameIndex::matches(const World& world, std::string_view path) const {
    std::vector<Entity> result;
    // The entity's own name is the whole path, or what follows one of its slashes.
    for (std::size_t begin = 0;; ++begin) {
        if (const auto entry = by_name_.find(path.substr(begin)); entry != by_name_.end())
            std::ranges::copy_if(entry->second, std::back_inserter(result),
                                 [&](Entity entity) { return is_called(world, entity, path); });
        begin = path.find('/', begin);
        if (begin == path.npos) break;
    }
    return result;
}

std::vector<Entity> NameIndex::find_all(const World& world, std::string_view path) const {
    std::vector<Entity> result = matches(world, path);
    sort_by_tree(world, result);
    return result;
}

Entity NameIndex::find_below(const World& world, Entity root, std::string_view path) const {
    std::vector<Entity> found = matches(world, path);
    // Many of that name, few below: copies of something, each with its own.
    std::vector<Entity> waiting{root};
    for (std::size_t looked_at = 0; !waiting.empty() && looked_at < found.size(); ++looked_at) {
        const Entity entity = waiting.back();
        waiting.pop_back();
        if (entity != root && is_called(world, entity, path)) return entity;
        const std::span<const Entity> children = world.children(entity);
        waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
    if (waiting.empty()) return Entity::null;
    std::erase_if(found, [&](Entity entity) { return !is_below(world, entity, root); });
    sort_by_tree(world, found);
    return found.empty() ? Entity::null : found.front();
}

} // namespace hachure
