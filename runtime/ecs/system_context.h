#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/tick.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace hachure {

class Commands;
class World;

/// System parameter: the tick in which the system last ran to its end; 0 before it did. `changed_since<C>(last.tick)`
/// of a query gives what others changed in the meantime.
struct LastRun {
    Tick tick = 0;
};

/// System parameter: the entities that lost C since the system last ran, in order of time, once per loss. They may be
/// dead, or have a C again. Holds while the system runs.
template <class C> class Removed {
public:
    explicit Removed(std::vector<Entity> entities) : entities_(std::move(entities)) {}

    auto begin() const { return entities_.begin(); }
    auto end() const { return entities_.end(); }
    std::size_t size() const { return entities_.size(); }
    bool empty() const { return entities_.empty(); }

private:
    std::vector<Entity> entities_;
};

namespace detail {

/// What a run of a system gets its parameters from.
struct SystemContext {
    World& world;
    Tick now;           ///< the system's own
    Tick last;          ///< see LastRun
    Commands* commands; ///< the system's own queue; null when it asks for none
};

} // namespace detail
} // namespace hachure
