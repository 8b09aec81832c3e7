// Adding a third component to each entity and removing it again, against the creation of their data in two vectors.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

namespace hachure::bench {
namespace {

constexpr double limit_add = 1.0;
constexpr double limit_remove = 1.3;

template <class C> void add_to_each(World& world, const std::vector<Entity>& entities) {
    for (std::size_t i = 0; i < entities.size(); ++i) world.add(entities[i], component<C>(i));
}

template <class C> double add(std::size_t count) {
    World world;
    const std::vector<Entity> entities = fill(world, count);
    const Stopwatch watch;
    add_to_each<C>(world, entities);
    const double ns = watch.ns() / static_cast<double>(count);
    require(world.query<const Position, const C>().count() == count, "each has the third component");
    return ns;
}

template <class C> double remove(std::size_t count) {
    World world;
    const std::vector<Entity> entities = fill(world, count);
    add_to_each<C>(world, entities);
    const Stopwatch watch;
    for (const Entity entity : entities) world.remove<C>(entity);
    const double ns = watch.ns() / static_cast<double>(count);
    require(world.query<const C>().empty(), "none has the third component");
    return ns;
}

} // namespace

Group component_group(std::size_t count) {
    const std::string adding = "add a third component";
    const std::string removing = "remove it again";
    Group group{"third component: raw push_back", [count] { return create_raw(count); }, {}};
    group.cases = {
        // In tables the whole entity moves: it pays where the component is walked far more often than it comes and
        // goes.
        {"third component: add", [count] { return add<Extra>(count); }, adding, {}},
        {"third component: add; sparse", [count] { return add<SparseExtra>(count); }, adding, limit_add},
        {"third component: remove", [count] { return remove<Extra>(count); }, removing, {}},
        {"third component: remove; sparse", [count] { return remove<SparseExtra>(count); }, removing, limit_remove},
    };
    return group;
}

} // namespace hachure::bench
