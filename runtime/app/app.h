#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/ecs/world.h>

#include <string>
#include <utility>

namespace hachure {

/// A world, the systems that run over it each frame, and the component types that files and command lines may name.
/// `register_NAME(app)` of systems/NAME adds a capability. Rendering needs more: see RenderContext.
class App {
public:
    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] Schedule& schedule() { return schedule_; }
    [[nodiscard]] TypeRegistry& types() { return types_; }
    [[nodiscard]] const TypeRegistry& types() const { return types_; }

    /// Makes component C known by its name.
    template <class C> void add_component() { types_.add<C>(); }

    /// Runs `system` in `stage` each frame; see `Schedule`. The handle says more, such as what it comes after.
    template <class F> SystemHandle add_system(Stage stage, std::string name, F system) {
        return schedule_.add(stage, std::move(name), std::move(system));
    }

    /// One frame, `delta_seconds` (0 or more) after the one before: every stage in order.
    void run_frame(double delta_seconds = 0) { schedule_.run(world_, delta_seconds); }

private:
    World world_;
    Schedule schedule_;
    TypeRegistry types_;
};

} // namespace hachure
