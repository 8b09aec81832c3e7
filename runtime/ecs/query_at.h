#pragma once

#include <hachure/runtime/ecs/world.h>

namespace hachure::detail {

/// The parts of a world that a query works on; until worlds make queries with a tick of their own.
QuerySource query_parts(const World& world);

template <class Q> struct QueryAt;
template <class... Terms> struct QueryAt<Query<Terms...>> {
    static Query<Terms...> make(World& world, const Tick& now) {
        QuerySource source = query_parts(world);
        source.now = &now;
        return Query<Terms...>(source);
    }
};

/// A query Q of `world` that marks what it writes with tick `now`, whatever the world's own tick is: several systems
/// walk queries at the same time, each in its own tick. `now` is kept by reference and outlives the query.
template <class Q> Q query_at(World& world, const Tick& now) { return QueryAt<Q>::make(world, now); }

} // namespace hachure::detail
