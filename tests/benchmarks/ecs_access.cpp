// Components of entities in random order, by handle, against elements of two arrays through an index: an array that
// leads from the ids of things to their places, as whoever keeps things in arrays and deletes some of them needs it.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

#include <memory>
#include <numeric>

namespace hachure::bench {
namespace {

constexpr double access_limit_over_raw = 1.5;

struct AccessData {
    explicit AccessData(std::size_t count) : handles(shuffled(fill(world, count))), ids(count) {
        for (std::size_t i = 0; i < count; ++i) {
            positions.push_back(component<Position>(i));
            velocities.push_back(component<Velocity>(i));
        }
        std::iota(ids.begin(), ids.end(), 0u);
        places = ids;
        ids = shuffled(ids);
    }

    World world;
    std::vector<Entity> handles;
    std::vector<std::uint32_t> ids;    ///< in the same random order
    std::vector<std::uint32_t> places; ///< by id
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
};

/// Times `sum()` over `count` keys, which returns a sum of what it reads: the second of two runs, because how much of
/// its data is in the cache at first depends on which case ran before.
template <class F> double time_second(std::size_t count, F sum) {
    keep(sum());
    const Stopwatch watch;
    keep(sum());
    return watch.ns() / static_cast<double>(count);
}

/// Times the sum of `read(key)` over all keys.
template <class Keys, class F> double visit(const Keys& keys, F read) {
    return time_second(keys.size(), [&] {
        float sum = 0.0f;
        for (const auto key : keys) sum += read(key);
        return sum;
    });
}

double read_raw(const AccessData& data) {
    return visit(data.ids, [&](std::uint32_t id) {
        const std::uint32_t place = data.places[id];
        return data.positions[place].x + data.velocities[place].y;
    });
}

/// Without the index: for things that never move and never go.
double read_raw_directly(const AccessData& data) {
    return visit(data.ids, [&](std::uint32_t id) { return data.positions[id].x + data.velocities[id].y; });
}

double get(const AccessData& data) {
    return visit(data.handles, [&](Entity entity) {
        return data.world.get<Position>(entity).x + data.world.get<Velocity>(entity).y;
    });
}

double get_both(const AccessData& data) {
    return visit(data.handles, [&](Entity entity) {
        const auto [position, velocity] = data.world.get<Position, Velocity>(entity);
        return position.x + velocity.y;
    });
}

double each_of(const AccessData& data) {
    return time_second(data.handles.size(), [&] {
        float sum = 0.0f;
        data.world.query<const Position, const Velocity>().each_of(
            data.handles, [&](const Position& position, const Velocity& velocity) { sum += position.x + velocity.y; });
        return sum;
    });
}

double get_mutable(AccessData& data) {
    return visit(data.handles, [&](Entity entity) { return data.world.get_mutable<Position>(entity).x += 1.0f; });
}

double has(const AccessData& data) {
    return visit(data.handles, [&](Entity entity) { return data.world.has<Velocity>(entity) ? 1.0f : 0.0f; });
}

} // namespace

Group access_group(std::size_t count) {
    auto data = std::make_shared<AccessData>(count);
    Group group{"random: raw arrays through an index", [data] { return read_raw(*data); }, {}};
    group.cases = {
        {"random: each_of two", [data] { return each_of(*data); }, "read two components at random",
         access_limit_over_raw},
        {"random: get two at once", [data] { return get_both(*data); }, "", access_limit_over_raw},
        {"random: get two", [data] { return get(*data); }, "read two components at random", access_limit_over_raw},
        {"random: raw arrays without an index", [data] { return read_raw_directly(*data); }, "", {}},
    };
    return group;
}

Group write_group(std::size_t count) {
    // A world of its own: what it writes, the readers above would have to fetch from memory.
    auto data = std::make_shared<AccessData>(count);
    Group group;
    group.cases = {
        {"random: get_mutable one", [data] { return get_mutable(*data); }, "", {}},
        {"random: has", [data] { return has(*data); }, "", {}},
    };
    return group;
}

} // namespace hachure::bench
