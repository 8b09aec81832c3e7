#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace hachure {

std::string_view to_string(Stage stage) {
    constexpr std::array<std::string_view, 8> names{"input",  "script", "animate",  "transform",
                                                    "deform", "light",  "material", "render"};
    return names[static_cast<std::size_t>(stage)];
}

void Schedule::add(Stage stage, std::string name, System system) {
    HACHURE_ASSERT(!running_, "systems are added between runs");
    HACHURE_ASSERT(system, "a system can be called");
    HACHURE_ASSERT(std::ranges::find(entries_, name, &Entry::name) == entries_.end(), "a system's name is its own");
    const auto place = std::ranges::upper_bound(entries_, stage, {}, &Entry::stage);
    entries_.insert(place, {stage, std::move(name), std::move(system)});
    times_.clear();
    for (const Entry& entry : entries_) times_.push_back({entry.name, entry.stage, 0.0});
}

void Schedule::run(World& world) {
    using Clock = std::chrono::steady_clock;
    HACHURE_ASSERT(!running_, "a system does not run its own schedule");

    struct EndAtExit {
        bool& running;
        ~EndAtExit() { running = false; }
    } const end_at_exit{running_};
    running_ = true;

    for (SystemTime& time : times_) time.ms = 0.0;
    const Tick begin = world.tick();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const auto start = Clock::now();
        entries_[i].system(world);
        world.apply_commands();
        world.advance_tick();
        times_[i].ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    // A system that last ran in the run before this one asked in a tick no earlier than last_begin_.
    world.forget_removed_before(last_begin_);
    last_begin_ = begin;
}

std::vector<std::string_view> Schedule::names() const {
    std::vector<std::string_view> result;
    for (const Entry& entry : entries_) result.push_back(entry.name);
    return result;
}

} // namespace hachure
