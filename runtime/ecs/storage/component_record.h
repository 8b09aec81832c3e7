#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/storage/change_log.h>
#include <hachure/runtime/ecs/storage/component_info.h>

#include <deque>
#include <functional>
#include <memory>

namespace hachure {
class World;
}

namespace hachure::detail {

class SparseStore;

using Observer = std::function<void(World&, Entity)>;

/// All that a world has of one component type besides the values in tables. It stays where it is while the world lives.
struct ComponentRecord {
    const ComponentInfo* info;
    ChangeLog log;
    std::unique_ptr<SparseStore> sparse; ///< of components with sparse storage
    std::deque<Observer> added;          ///< no vector: an observer that adds another one stays where it is
    std::deque<Observer> removed;

    bool observed() const { return !added.empty() || !removed.empty(); }

    explicit ComponentRecord(const ComponentInfo& of);
    ~ComponentRecord();
    ComponentRecord(const ComponentRecord&) = delete;
    ComponentRecord& operator=(const ComponentRecord&) = delete;
};

} // namespace hachure::detail
