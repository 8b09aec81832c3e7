#include <hachure/editor/play/allocation_counter.h>

namespace hachure::play {
namespace {

/// Resource: the counter's values at the ends of what is counted.
struct AllocationWindow {
    std::uint64_t begin = 0, end = 0;
};

std::uint64_t now() { return allocation_counter.count.load(std::memory_order_relaxed); }

} // namespace

constinit AllocationCounter allocation_counter;

void count_allocations(App& app) {
    allocation_counter.counting = true;
    app.world().set_resource(AllocationWindow{});
    // Registered first, they come first in their stages; exclusive, they have nothing beside them.
    app.add_system(Stage::input, "play.count_allocations",
                   [](World& world) { world.resource_mutable<AllocationWindow>().begin = now(); });
    app.add_system(Stage::render, "play.end_count",
                   [](World& world) { world.resource_mutable<AllocationWindow>().end = now(); });
}

std::optional<std::uint64_t> allocations_of_frame(const World& world) {
    const AllocationWindow* window = world.find_resource<AllocationWindow>();
    if (!window || !allocation_counter.installed) return std::nullopt;
    return window->end - window->begin;
}

} // namespace hachure::play
