#pragma once

#include <hachure/runtime/ecs/world.h>

namespace hachure::detail {

template <class Q> struct QueryAt;
template <class... Terms> struct QueryAt<Query<Terms...>> {
    static Query<Terms...> make(World& world, Tick now) { return world.query_at<Terms...>(now); }
};

/// A query Q of `world` that marks what it writes with tick `now`, whatever the world's own tick is: several systems
/// walk queries at the same time, each in its own tick.
template <class Q> Q query_at(World& world, Tick now) { return QueryAt<Q>::make(world, now); }

} // namespace hachure::detail
