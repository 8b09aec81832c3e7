#include <hachure/runtime/ecs/schedule/run_batch.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>
#include <chrono>

namespace hachure::detail {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void prepare(SystemEntry& system, World& world, Tick now) {
    system.now = now;
    if (!system.access.commands || system.commands_world == &world) return;
    system.commands = std::make_unique<Commands>(world);
    system.commands_world = &world;
}

void run_system(SystemEntry& system, World& world) {
    const auto start = Clock::now();
    const SystemContext context{world, system.now, system.last, system.commands.get()};
    for (const auto& condition : system.conditions)
        if (!condition->call(context)) return;
    system.body->call(context);
    // An exclusive system may have moved the world's tick; it does not see its own changes then, either.
    system.last = system.access.exclusive ? world.tick() : system.now;
    system.ms += ms_since(start);
}

void apply_commands(SystemEntry& system, World& world) {
    if (!system.commands || system.commands->empty()) return;
    const auto start = Clock::now();
    system.commands->apply(world);
    system.ms += ms_since(start);
}

bool has_commands(const Batch& batch) {
    return std::ranges::any_of(batch.systems, [](const SystemEntry* system) { return system->access.commands; });
}

void run_exclusive(World& world, SystemEntry& system) {
    run_system(system, world);
    apply_commands(system, world);
    const auto start = Clock::now();
    if (world.commands().empty()) return;
    world.apply_commands();
    system.ms += ms_since(start);
}

void run_parallel(World& world, const Batch& batch) {
    parallel_graph(batch.graph, [&](std::size_t i) { run_system(*batch.systems[i], world); });
    if (!has_commands(batch)) return;
    for (std::size_t i = 0; i < batch.systems.size(); ++i) world.advance_tick();
    for (SystemEntry* system : batch.systems) apply_commands(*system, world);
}

/// Moves the world's tick behind all ticks of the batch, whether it came to its end or not.
void pass_ticks(World& world, Tick begin, const Batch& batch) {
    const Tick end =
        begin + batch.systems.size() + (has_commands(batch) && !batch.systems[0]->access.exclusive ? 1 : 0);
    do {
        world.advance_tick();
    } while (world.tick() < end);
}

void drop_commands(World& world, const Batch& batch) {
    for (SystemEntry* system : batch.systems)
        if (system->commands) system->commands->clear();
    if (batch.systems[0]->access.exclusive) world.commands().clear();
}

} // namespace

void run_batch(World& world, const Batch& batch) {
    const Tick begin = world.tick();
    for (std::size_t i = 0; i < batch.systems.size(); ++i) prepare(*batch.systems[i], world, begin + i);
    try {
        if (batch.systems[0]->access.exclusive)
            run_exclusive(world, *batch.systems[0]);
        else
            run_parallel(world, batch);
    } catch (...) {
        drop_commands(world, batch);
        pass_ticks(world, begin, batch);
        throw;
    }
    pass_ticks(world, begin, batch);
}

} // namespace hachure::detail
