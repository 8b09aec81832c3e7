// Trees of ten entities: building them, and destroying them by their roots.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

namespace hachure::bench {
namespace {

constexpr std::size_t tree_size = 10; ///< a root and its children

/// Calls `f(child, root)` for every entity that is no root.
template <class F> void for_each_child(const std::vector<Entity>& entities, F f) {
    for (std::size_t i = 0; i < entities.size(); ++i)
        if (i % tree_size != 0) f(entities[i], entities[i - i % tree_size]);
}

double set_parent(std::size_t count) {
    World world;
    const std::vector<Entity> entities = fill(world, count);
    const Stopwatch watch;
    for_each_child(entities, [&](Entity child, Entity root) { world.set_parent(child, root); });
    const double ns = watch.ns() / static_cast<double>(count);
    require(world.children(entities[0]).size() == std::min(count, tree_size) - 1, "the first root has its children");
    return ns;
}

double destroy_trees(std::size_t count) {
    World world;
    const std::vector<Entity> entities = fill(world, count);
    for_each_child(entities, [&](Entity child, Entity root) { world.set_parent(child, root); });
    const Stopwatch watch;
    for (std::size_t i = 0; i < count; i += tree_size) world.destroy(entities[i]);
    const double ns = watch.ns() / static_cast<double>(count);
    require(world.size() == 0, "children went with their roots");
    return ns;
}

} // namespace

Group tree_group(std::size_t count) {
    Group group;
    group.cases = {
        {"tree: set_parent", [count] { return set_parent(count); }, "", {}},
        {"tree: destroy by roots", [count] { return destroy_trees(count); }, "", {}},
    };
    return group;
}

} // namespace hachure::bench
