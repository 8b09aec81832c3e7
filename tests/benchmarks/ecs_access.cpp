// Components of entities in random order, by handle, against elements of two arrays by index.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

#include <memory>
#include <numeric>

namespace hachure::bench {
namespace {

constexpr double limit_over_raw = 1.5;

struct Data {
    explicit Data(std::size_t count) : handles(shuffled(fill(world, count))), indices(count) {
        for (std::size_t i = 0; i < count; ++i) {
            positions.push_back(component<Position>(i));
            velocities.push_back(component<Velocity>(i));
        }
        std::iota(indices.begin(), indices.end(), 0u);
        indices = shuffled(indices);
    }

    World world;
    std::vector<Entity> handles;
    std::vector<std::uint32_t> indices; ///< in the same random order
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
};

/// Times `read(key)` over all keys; a sum of what it returns is kept.
template <class Keys, class F> double visit(const Keys& keys, F read) {
    float sum = 0.0f;
    const Stopwatch watch;
    for (const auto key : keys) sum += read(key);
    keep(sum);
    return watch.ns() / static_cast<double>(keys.size());
}

double read_raw(const Data& data) {
    return visit(data.indices, [&](std::uint32_t i) { return data.positions[i].x + data.velocities[i].y; });
}

double get(const Data& data) {
    return visit(data.handles, [&](Entity entity) {
        return data.world.get<Position>(entity).x + data.world.get<Velocity>(entity).y;
    });
}

double each_of(const Data& data) {
    float sum = 0.0f;
    const Stopwatch watch;
    data.world.query<const Position, const Velocity>().each_of(
        data.handles, [&sum](const Position& position, const Velocity& velocity) { sum += position.x + velocity.y; });
    keep(sum);
    return watch.ns() / static_cast<double>(data.handles.size());
}

double get_mutable(Data& data) {
    return visit(data.handles, [&](Entity entity) { return data.world.get_mutable<Position>(entity).x += 1.0f; });
}

double has(const Data& data) {
    return visit(data.handles, [&](Entity entity) { return data.world.has<Velocity>(entity) ? 1.0f : 0.0f; });
}

} // namespace

Group access_group(std::size_t count) {
    auto data = std::make_shared<Data>(count);
    Group group{"random: raw arrays by index", [data] { return read_raw(*data); }, {}};
    group.cases = {
        {"random: each_of two", [data] { return each_of(*data); }, "read two components at random", limit_over_raw},
        // One by one, the row of a handle is found before its values can be fetched: three dependent steps through
        // memory, where two independent ones lead to two array elements.
        {"random: get two", [data] { return get(*data); }, "read two components at random", {}},
        {"random: get_mutable one", [data] { return get_mutable(*data); }, "", {}},
        {"random: has", [data] { return has(*data); }, "", {}},
    };
    return group;
}

} // namespace hachure::bench
