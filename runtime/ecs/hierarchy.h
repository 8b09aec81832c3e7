#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/entity_map.h>

#include <vector>

namespace hachure {

/// On every entity that has a parent. Written by `World::set_parent` and `World::clear_parent` alone; reparenting
/// marks it changed, so that `changed_since<Parent>` finds what moved in the tree.
struct Parent {
    Entity entity; ///< alive, and no descendant of the entity that carries this
};

/// On every entity that has at least one child. Written by `World::set_parent`, `clear_parent` and `destroy` alone;
/// marked changed when a child comes or goes.
struct Children {
    std::vector<Entity> entities; ///< in order of insertion
};

inline void remap_entities(Parent& parent, const EntityMap& copies) { parent.entity = copies(parent.entity); }
inline void remap_entities(Children& children, const EntityMap& copies) {
    for (Entity& child : children.entities) child = copies(child);
}

namespace detail {
/// Components that only the world itself writes, because two of them must agree.
template <class C> inline constexpr bool managed_by_world = false;
template <> inline constexpr bool managed_by_world<Parent> = true;
template <> inline constexpr bool managed_by_world<Children> = true;
} // namespace detail

} // namespace hachure
