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

    store_->lock().assert_idle();
    detach(child);
    assign<Parent>(child, Parent{parent});
    detail::Location at;
    if (Children* children = store_->find<Children>(parent, at)) {
        children->entities.push_back(child);
        store_->mark(detail::component_id<Children>(), parent, at, tick());
    } else {
        assign<Children>(parent, Children{{child}});
    }
}

void World::clear_parent(Entity child) {
    if (!parent(child)) return;
    store_->lock().assert_idle();
    detach(child);
    erase<Parent>(child);
}

void World::detach(Entity child) {
    const Entity old_parent = parent(child);
    if (!old_parent) return;
    detail::Location at;
    auto& siblings = store_->find<Children>(old_parent, at)->entities;
    siblings.erase(std::find(siblings.begin(), siblings.end(), child));
    store_->mark(detail::component_id<Children>(), old_parent, at, tick());
    if (siblings.empty()) erase<Children>(old_parent);
}

} // namespace hachure
