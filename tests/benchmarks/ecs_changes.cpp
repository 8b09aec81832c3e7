// Finding what changed: the time of one walk over a world of which a part is dirty.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

#include <fmt/format.h>

#include <memory>
#include <span>

namespace hachure::bench {
namespace {

struct Data {
    explicit Data(std::size_t count) : handles(shuffled(fill(world, count))) {}

    World world;
    std::vector<Entity> handles;
};

/// Writes to `dirty` entities anywhere, then finds them: microseconds for the walk that does.
double find_changed(Data& data, std::size_t dirty) {
    const Tick before = data.world.tick();
    data.world.advance_tick();
    for (const Entity entity : std::span(data.handles).first(dirty)) data.world.get_mutable<Position>(entity).x += 1.0f;
    data.world.advance_tick();
    std::size_t found = 0;
    float sum = 0.0f;
    const Stopwatch watch;
    for (auto [entity, position] : data.world.query<const Position>().changed_since<Position>(before)) {
        sum += position.x;
        ++found;
    }
    keep(sum);
    const double microseconds = 1e-3 * watch.ns();
    require(found == dirty, "what changed was found, and nothing else");
    return microseconds;
}

} // namespace

Group change_group(std::size_t count) {
    auto data = std::make_shared<Data>(count);
    Group group;
    for (const double percent : {0.0, 0.1, 1.0, 3.0, 10.0, 50.0, 100.0}) {
        const auto dirty = static_cast<std::size_t>(0.01 * percent * static_cast<double>(count));
        group.cases.push_back({fmt::format("changed_since: {} % dirty", percent),
                               [data, dirty] { return find_changed(*data, dirty); },
                               "",
                               {},
                               "us/walk"});
    }
    return group;
}

} // namespace hachure::bench
