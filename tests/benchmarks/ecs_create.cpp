// Creating entities, one by one and many at a time, against appending the same data to two vectors.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

namespace hachure::bench {
namespace {

constexpr double create_limit_one_by_one = 4.0;
constexpr double create_limit_in_bulk = 2.0;

/// Times what `make` does to a fresh world, per entity.
template <class F> double create(std::size_t count, F make) {
    World world;
    const Stopwatch watch;
    make(world);
    const double ns = watch.ns() / static_cast<double>(count);
    require(world.size() == count, "that many entities exist");
    require(world.query<const Position, const Velocity>().count() == count, "each has both components");
    return ns;
}

double create_with(std::size_t count) {
    return create(count, [count](World& world) {
        for (std::size_t i = 0; i < count; ++i) world.create_with(component<Position>(i), component<Velocity>(i));
    });
}

double create_and_add(std::size_t count) {
    return create(count, [count](World& world) {
        for (std::size_t i = 0; i < count; ++i) {
            const Entity entity = world.create();
            world.add(entity, component<Position>(i));
            world.add(entity, component<Velocity>(i));
        }
    });
}

double create_with_five(std::size_t count) {
    return create(count, [count](World& world) {
        for (std::size_t i = 0; i < count; ++i)
            world.create_with(component<Position>(i), component<Velocity>(i), component<Extra>(i), component<Fourth>(i),
                              component<Fifth>(i));
    });
}

double create_each(std::size_t count) {
    return create(count, [count](World& world) {
        world.create_each<Position, Velocity>(count, [](std::size_t i, Entity, Position& p, Velocity& v) {
            p = component<Position>(i);
            v = component<Velocity>(i);
        });
    });
}

double create_many(std::size_t count) {
    return create(count, [count](World& world) {
        keep(world.create_many(count, component<Position>(1), component<Velocity>(2)));
    });
}

} // namespace

double create_raw(std::size_t count) {
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
    const Stopwatch watch;
    for (std::size_t i = 0; i < count; ++i) {
        positions.push_back(component<Position>(i));
        velocities.push_back(component<Velocity>(i));
    }
    keep(*positions.data());
    keep(*velocities.data());
    return watch.ns() / static_cast<double>(count);
}

Group create_group(std::size_t count) {
    const std::string single = "create one by one";
    const std::string bulk = "create in bulk";
    Group group{"create: raw push_back", [count] { return create_raw(count); }, {}};
    group.cases = {
        {"create: create_with(p v)", [count] { return create_with(count); }, single, create_limit_one_by_one},
        {"create: create + add + add", [count] { return create_and_add(count); }, single, create_limit_one_by_one},
        {"create: create_each", [count] { return create_each(count); }, bulk, create_limit_in_bulk},
        {"create: create_many", [count] { return create_many(count); }, bulk, create_limit_in_bulk},
        {"create: create_with five components", [count] { return create_with_five(count); }, "", {}},
    };
    return group;
}

} // namespace hachure::bench
