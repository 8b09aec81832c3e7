// How much memory an entity with two components of 12 bytes takes.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>
#include <hachure/tests/benchmarks/ecs_process.h>

namespace hachure::bench {
namespace {

double bytes_per_entity(std::size_t count) {
    const std::size_t before = resident_bytes();
    World world;
    for (std::size_t i = 0; i < count; ++i) world.create_with(component<Position>(i), component<Velocity>(i));
    const std::size_t after = resident_bytes();
    return static_cast<double>(after - std::min(before, after)) / static_cast<double>(count);
}

} // namespace

Group footprint_group(std::size_t count) {
    Group group;
    group.cases = {
        {"memory per entity (24 bytes of data)", [count] { return bytes_per_entity(count); }, "", {}, "bytes"}};
    return group;
}

} // namespace hachure::bench
