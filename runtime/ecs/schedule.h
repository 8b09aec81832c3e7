#pragma once

#include <hachure/runtime/ecs/tick.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

class World;

/// The parts of a frame, in order.
enum class Stage {
    input,     ///< reads window, keyboard, pointer and recorded playback into components
    script,    ///< the user's own logic, timelines and scripts
    animate,   ///< samples clips and drivers into local transforms, joint poses and weights
    transform, ///< local transforms and parents to world transforms
    deform,    ///< skins and morphs meshes, and renews what depends on their shape (normals, bounds, curvature)
    light,     ///< moves lights and decides what each of them reaches
    material,  ///< the CPU side of materials: strokes, maps and tables that follow shape and light
    render,    ///< declares this frame's passes and runs them
};

/// The stage as it is spelled above.
std::string_view to_string(Stage stage);

/// What one system took in the last run.
struct SystemTime {
    std::string_view name; ///< as given to `Schedule::add`; holds while the schedule lives and none is added
    Stage stage;
    double ms; ///< wall clock, the system's commands included
};

/// The systems of one world, and the order in which they run: by stage, within a stage in order of registration.
class Schedule {
public:
    using System = std::function<void(World&)>;

    Schedule() = default;
    Schedule(Schedule&&) = default;
    Schedule& operator=(Schedule&&) = default;

    /// Adds a system under a name of its own. Not from within a system.
    void add(Stage stage, std::string name, System system);

    /// Runs every system once on `world`, which is the same each time. After each one the world's commands are applied
    /// and its tick advances. Removals older than the run before this one are forgotten: a system that looks at them
    /// runs every time, or misses some. An exception of a system ends the run.
    void run(World& world);

    /// One entry per system in order, from the last run; 0 ms for a system that has not run in it.
    std::span<const SystemTime> times() const { return times_; }

    /// The names in the order in which the systems run.
    std::vector<std::string_view> names() const;

private:
    struct Entry {
        Stage stage;
        std::string name;
        System system;
    };

    std::vector<Entry> entries_; ///< in the order in which they run
    std::vector<SystemTime> times_;
    Tick last_begin_ = 0; ///< the tick in which the last run began
    bool running_ = false;
};

} // namespace hachure
