#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <unordered_map>

namespace hachure {

/// From originals to their copies, while `World::instantiate` copies a tree. A component that refers to entities offers
///
///     inline void remap_entities(Follow& follow, const EntityMap& copies) { follow.target = copies(follow.target); }
///
/// beside it; it is called for each copy of the component.
class EntityMap {
public:
    void insert(Entity original, Entity copy) { copies_[original] = copy; }

    /// The copy of `original`; itself where it was not copied.
    Entity operator()(Entity original) const {
        const auto found = copies_.find(original);
        return found != copies_.end() ? found->second : original;
    }

    void clear() { copies_.clear(); }

private:
    std::unordered_map<Entity, Entity> copies_;
};

} // namespace hachure
