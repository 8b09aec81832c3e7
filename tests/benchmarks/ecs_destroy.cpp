// Destroying entities, one by one and many at a time, against the creation of their data in two vectors.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

namespace hachure::bench {
namespace {

constexpr double destroy_limit_one_by_one = 2.2;
constexpr double destroy_limit_in_bulk = 1.0;

/// Times what `end` does to a full world, per entity. `arrange` puts the handles into the order that it wants.
template <class Arrange, class F> double destroy(std::size_t count, Arrange arrange, F end) {
    World world;
    const std::vector<Entity> entities = arrange(fill(world, count));
    const Stopwatch watch;
    end(world, entities);
    const double ns = watch.ns() / static_cast<double>(count);
    require(world.size() == 0, "no entity is left");
    require(world.query<const Position>().empty(), "no component is left");
    return ns;
}

std::vector<Entity> as_created(std::vector<Entity> entities) { return entities; }

std::vector<Entity> reversed(std::vector<Entity> entities) {
    std::ranges::reverse(entities);
    return entities;
}

void one_by_one(World& world, const std::vector<Entity>& entities) {
    for (const Entity entity : entities) world.destroy(entity);
}

} // namespace

Group destroy_group(std::size_t count) {
    const std::string single = "destroy one by one";
    const std::string bulk = "destroy in bulk";
    const auto many = [](World& world, const std::vector<Entity>& entities) { world.destroy_many(entities); };
    const auto matching = [](World& world, const std::vector<Entity>&) {
        world.destroy_matching(world.query<const Position>());
    };
    const auto clear = [](World& world, const std::vector<Entity>&) { world.clear(); };
    Group group{"destroy: raw push_back", [count] { return create_raw(count); }, {}};
    group.cases = {
        {"destroy: in order of creation", [=] { return destroy(count, as_created, one_by_one); }, single,
         destroy_limit_one_by_one},
        {"destroy: in reverse", [=] { return destroy(count, reversed, one_by_one); }, single, {}},
        {"destroy: in random order", [=] { return destroy(count, shuffled<Entity>, one_by_one); }, single, {}},
        {"destroy: destroy_many", [=] { return destroy(count, as_created, many); }, bulk, destroy_limit_in_bulk},
        {"destroy: destroy_matching", [=] { return destroy(count, as_created, matching); }, bulk,
         destroy_limit_in_bulk},
        {"destroy: clear", [=] { return destroy(count, as_created, clear); }, bulk, destroy_limit_in_bulk},
    };
    return group;
}

} // namespace hachure::bench
