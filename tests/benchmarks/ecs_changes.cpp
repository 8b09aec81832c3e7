// Finding what changed: the time of one walk over a world of which a part is dirty.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

#include <fmt/format.h>

#include <memory>
#include <span>
#include <string_view>

namespace hachure::bench {
namespace {

struct ChangeData {
    explicit ChangeData(std::size_t count) : handles(shuffled(fill(world, count))) {}

    World world;
    std::vector<Entity> handles;
};

/// Writes to `dirty` entities anywhere, then finds them: microseconds for the walk that does.
double find_changed(ChangeData& data, std::size_t dirty, detail::ChangeWalk how) {
    const Tick before = data.world.tick();
    data.world.advance_tick();
    for (const Entity entity : std::span(data.handles).first(dirty)) data.world.get_mutable<Position>(entity).x += 1.0f;
    data.world.advance_tick();
    std::size_t found = 0;
    float sum = 0.0f;
    const Stopwatch watch;
    const auto query = data.world.query<const Position>().changed_since<Position>(before).finding_changes(how);
    for (auto [entity, position] : query) {
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
    auto data = std::make_shared<ChangeData>(count);
    Group group;
    // The queue is given up past a sixteenth of the entities: from there on both ways are the sweep.
    for (const double percent : {0.0, 0.1, 1.0, 3.0, 6.0, 10.0, 50.0, 100.0}) {
        const auto dirty = static_cast<std::size_t>(0.01 * percent * static_cast<double>(count));
        const auto add = [&](std::string_view way, detail::ChangeWalk how) {
            group.cases.push_back({fmt::format("changed_since: {} % dirty{}", percent, way),
                                   [data, dirty, how] { return find_changed(*data, dirty, how); },
                                   "",
                                   {},
                                   "us/walk"});
        };
        add("", detail::ChangeWalk::automatic);
        if (percent == 0.0 || percent > 6.0) continue;
        add("; queue", detail::ChangeWalk::queue);
        add("; sweep", detail::ChangeWalk::sweep);
    }
    return group;
}

} // namespace hachure::bench
