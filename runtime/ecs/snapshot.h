#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/unknown_components.h>

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace hachure {

/// The world as bytes, in the format of docs/snapshots.md: which entities live and which handles come next, the tree,
/// and the registered components with those of their fields that differ from the defaults. What `restore_snapshot` did
/// not know of an earlier snapshot is written again. Not saved are components that are not registered, members that no
/// field describes, resources, and ticks.
///
/// The same entities, tree and values give the same bytes, in whatever order they came about. Queued commands are
/// applied before: an entity that is reserved and not yet alive asserts. Throws Error(component.field, fault) when a
/// component holds a value that its field forbids.
[[nodiscard]] std::vector<std::byte> save_snapshot(const World& world, const TypeRegistry& types);

/// Makes the world the one that was saved: same entities with same handles, and the next ones get the same handles too.
/// All entities that were there are destroyed; resources stay, but for UnknownComponents. Everything counts as added in
/// the current tick. Queries visit in order of slots.
///
/// Fields that the snapshot does not have take their defaults. Component types and fields that `types` does not have
/// are kept in the world as UnknownComponents. Numbers are converted when their field has another type now.
///
/// Throws Error(subject, fault, "byte N") when the bytes are no snapshot, of another version, truncated or altered, or
/// when a value does not fit its field; the world is as it was then.
void restore_snapshot(World& world, const TypeRegistry& types, std::span<const std::byte> snapshot,
                      std::string_view subject = "snapshot");

} // namespace hachure
