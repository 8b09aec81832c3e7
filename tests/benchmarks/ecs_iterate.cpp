// Walking a million entities against walking two arrays.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

#include <memory>

namespace hachure::bench {
namespace {

constexpr double iterate_limit_over_raw = 1.2;

/// The same data as arrays, in a world of one kind of entity, and in one where every second entity has a tag and every
/// fourth a third component.
struct IterateData {
    explicit IterateData(std::size_t n) : count(n), repeats(std::max<std::size_t>(1, 200'000 / n)) {
        for (std::size_t i = 0; i < n; ++i) {
            positions.push_back(component<Position>(i));
            velocities.push_back(component<Velocity>(i));
        }
        fill(world, n);
        const std::vector<Entity> entities = fill(mixed, n);
        for (std::size_t i = 0; i < n; ++i) {
            if (i % 2 == 0) mixed.add<Tag>(entities[i]);
            if (i % 4 == 0) mixed.add(entities[i], component<Extra>(i));
        }
    }

    /// What `walk` takes per visit. A short walk is done many times over, as the clock has its own cost.
    template <class F> double time(std::size_t visits, F walk) const {
        const Stopwatch watch;
        for (std::size_t i = 0; i < repeats; ++i) walk();
        return watch.ns() / static_cast<double>(visits * repeats);
    }

    std::size_t count, repeats;
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
    World world, mixed;
};

double walk_raw(IterateData& data) {
    return data.time(data.count, [&] {
        for (std::size_t i = 0; i < data.count; ++i) move_by(data.positions[i], data.velocities[i]);
        keep(*data.positions.data());
    });
}

double walk_range(IterateData& data) {
    return data.time(data.count, [&] {
        for (auto [entity, position, velocity] : data.world.query<Position, const Velocity>())
            move_by(position, velocity);
        keep(data.world);
    });
}

double walk_each(IterateData& data) {
    return data.time(data.count, [&] {
        data.world.query<Position, const Velocity>().each(
            [](Position& position, const Velocity& velocity) { move_by(position, velocity); });
        keep(data.world);
    });
}

double walk_reading(IterateData& data) {
    return data.time(data.count, [&] {
        float sum = 0.0f;
        for (auto [entity, position, velocity] : data.world.query<const Position, const Velocity>())
            sum += position.x + velocity.y;
        keep(sum);
    });
}

double walk_optional(IterateData& data) {
    return data.time(data.count, [&] {
        for (auto [entity, position, extra] : data.mixed.query<Position, Optional<const Extra>>())
            position.x += extra ? extra->x : 1.0f;
        keep(data.mixed);
    });
}

double walk_tagged(IterateData& data) {
    return data.time((data.count + 1) / 2, [&] {
        for (auto [entity, position, velocity] : data.mixed.query<Position, const Velocity, With<Tag>>())
            move_by(position, velocity);
        keep(data.mixed);
    });
}

/// Per query: making one that nothing can match, and finding that out.
double ask_for_nothing(IterateData& data) {
    constexpr int queries = 1000;
    std::size_t matches = 0;
    const Stopwatch watch;
    for (int i = 0; i < queries; ++i) matches += data.mixed.query<const Position, const Never>().empty() ? 0 : 1;
    const double ns = watch.ns() / queries;
    require(matches == 0, "nothing has a component Never");
    return ns;
}

} // namespace

Group iterate_group(std::size_t count) {
    auto data = std::make_shared<IterateData>(count);
    const std::string panel = "iterate two components";
    Group group{"iterate: raw arrays", [data] { return walk_raw(*data); }, {}};
    group.cases = {
        {"iterate: range-for", [data] { return walk_range(*data); }, panel, iterate_limit_over_raw},
        {"iterate: each", [data] { return walk_each(*data); }, panel, iterate_limit_over_raw},
        {"iterate: read only", [data] { return walk_reading(*data); }, "", {}},
        {"iterate: one of two optional", [data] { return walk_optional(*data); }, "", {}},
        {"iterate: the half with a tag", [data] { return walk_tagged(*data); }, "", {}},
        {"query that matches nothing", [data] { return ask_for_nothing(*data); }, "", {}, "ns/query"},
    };
    return group;
}

} // namespace hachure::bench
