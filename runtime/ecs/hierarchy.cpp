#include <hachure/runtime/ecs/hierarchy.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>

namespace hachure {

Entity World::parent(Entity entity) const {
    const Parent* found = find<Parent>(entity);
    return found ? found->entity : Entity::null;
}

std::span<const Entity> World::children(Entity entity) const {
    const Children* found = find<Children>(entity);
    return found ? std::span<const Entity>(found->entities) : std::span<const Entity>{};
}

std::vector<Entity> World::descendants(Entity entity) const {
    // Without recursion: a tree may be as deep as the world is large.
    std::vector<Entity> result;
    const auto roots = children(entity);
    std::vector<Entity> pending(roots.rbegin(), roots.rend());
    while (!pending.empty()) {
        result.push_back(pending.back());
        pending.pop_back();
        const auto next = children(result.back());
        pending.insert(pending.end(), next.rbegin(), next.rend());
    }
    return result;
}

void World::set_parent(Entity child, Entity parent) {
    require_alive(child);
    require_alive(parent);
    // A leaf is above nobody, so that a chain grown at its end takes linear time.
    const bool leaf = children(child).empty() && child != parent;
    for (Entity ancestor = leaf ? Entity::null : parent; ancestor; ancestor = this->parent(ancestor))
        if (ancestor == child) throw HierarchyCycle(child, parent);
    if (this->parent(child) == parent) return;

    lock_.assert_idle();
    detach(child);
    assign<Parent>(child, Parent{parent});
    auto& store = stores_.ensure<Children>();
    if (const std::uint32_t row = store.row(parent); row != detail::no_row) {
        store.value(row).entities.push_back(child);
        store.mark_changed(row, tick_);
    } else {
        store.insert(parent, Children{{child}}, tick_);
    }
}

void World::clear_parent(Entity child) {
    if (!parent(child)) return;
    lock_.assert_idle();
    detach(child);
    stores_.ensure<Parent>().erase(child, tick_);
}

void World::detach(Entity child) {
    const Entity old_parent = parent(child);
    if (!old_parent) return;
    auto& store = stores_.ensure<Children>();
    const std::uint32_t row = store.row(old_parent);
    auto& siblings = store.value(row).entities;
    siblings.erase(std::find(siblings.begin(), siblings.end(), child));
    store.mark_changed(row, tick_);
    if (siblings.empty()) store.erase(old_parent, tick_);
}

} // namespace hachure
