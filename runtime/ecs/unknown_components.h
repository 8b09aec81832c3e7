#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <cstddef>
#include <vector>

namespace hachure {

/// A resource: what a restored snapshot held that the registry has no type or field for. `save_snapshot` writes it
/// again for the entities that are still alive, so that a program that lacks a component does not lose it. Types are
/// registered before a snapshot is restored: when one is registered after it and a component of it is added, the
/// components that wait here are not written. The content is for `save_snapshot` alone.
struct UnknownComponents {
    std::vector<Entity> entities;               ///< those that were alive in the snapshot, in order of slots
    std::vector<std::vector<std::byte>> types;  ///< unknown component types, each as in the snapshot
    std::vector<std::vector<std::byte>> fields; ///< known component types with nothing but their unknown fields
};

} // namespace hachure
