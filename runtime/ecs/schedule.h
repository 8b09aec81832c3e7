#pragma once

#include <hachure/runtime/ecs/access.h>
#include <hachure/runtime/ecs/schedule/fixed_step.h>
#include <hachure/runtime/ecs/schedule/schedule_plan.h>
#include <hachure/runtime/ecs/schedule/system.h>
#include <hachure/runtime/ecs/schedule/system_entry.h>
#include <hachure/runtime/ecs/stage.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/runtime/ecs/time.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hachure {

class Schedule;

/// What one system took in the last run.
struct SystemTime {
    std::string_view name; ///< as given to `Schedule::add`; holds while the schedule lives
    Stage stage;
    double ms; ///< wall clock, conditions and commands included; the sum over fixed steps
};

/// What a schedule knows of one system before it runs.
struct SystemInfo {
    std::string_view name; ///< holds while the schedule lives
    Stage stage;
    Access access; ///< of the system and its conditions
};

/// Two systems that would run at the same time if they did not conflict, and that nobody has put in order: their order
/// is that of registration, by chance.
struct Ambiguity {
    std::string_view first; ///< runs first today; names hold while the schedule lives
    std::string_view second;
    Stage stage;
    std::vector<std::string_view> on; ///< what they conflict on, as `contested` says
    bool operator==(const Ambiguity&) const = default;
};

/// A system just added, to say more about it; to be used at once.
class SystemHandle {
public:
    /// Runs it before the system of that name. Names of systems that never come mean nothing. The two share a stage, or
    /// their stages agree.
    SystemHandle& before(std::string name);

    /// Runs it after the system of that name, and after the commands of that one are applied.
    SystemHandle& after(std::string name);

    /// Runs it only when `condition` says so, as must all others given. It is a callable that returns bool, with
    /// parameters as a system's of those kinds that only read; LastRun, EventReader and Removed there are the system's.
    template <class F> SystemHandle& run_if(F condition);

    /// Runs it once per fixed step instead of once per frame.
    SystemHandle& fixed();

private:
    friend class Schedule;
    SystemHandle(Schedule& schedule, detail::SystemEntry& entry) : schedule_(&schedule), entry_(&entry) {}

    SystemHandle& add_condition(std::unique_ptr<detail::Callable<bool>> condition);

    Schedule* schedule_;
    detail::SystemEntry* entry_;
};

/// The systems of one world, and the order in which they run.
///
/// A system is a function, or an object with one `operator()`, whose parameters say what it reads and writes:
///
///     Query<Terms...>                     components: `const T` and Optional<const T> are read, `T` is written
///     const R&, R&                        resource R, read or written; a run throws MissingResource when there is none
///     const R*, R*                        the same, null when there is none
///     Commands&                           a queue of the system's own
///     EventReader<E>, EventWriter<E>      events
///     LastRun, Removed<C>                 when it last ran, and who lost C since
///     const World&                        anything, read
///     World&                              anything: such a system runs alone, on the thread that called `run`
///
/// Systems run, or seem to run, in one order: by stage, in a stage by registration, changed by `before` and `after` so
/// that of the systems whose predecessors all ran the earliest registered is next. Neighbours in it that do not
/// conflict run at the same time, on any thread, up to the next stage, exclusive system, or system that is `after` one
/// with Commands. Their commands are applied there, in the order of the systems. Each system has its own tick; results,
/// changes and handles of new entities are the same with any number of threads. Code that is bound to a thread, such as
/// OpenGL, takes World&. A filter such as `changed_since<C>` reads C: name C in a term of the query, as `const C`.
class Schedule {
public:
    Schedule() = default;
    Schedule(Schedule&&) = default;
    Schedule& operator=(Schedule&&) = default;

    /// Adds a system under a name of its own. Not from within a system.
    template <class F> SystemHandle add(Stage stage, std::string name, F system) {
        if constexpr (detail::check_system<F>())
            return add_system(stage, std::move(name), detail::make_callable(std::move(system)));
    }

    /// Forgets events of type E after a while, too, which no system names in a parameter.
    template <class E> void add_event() {
        detail::SystemNeeds needs;
        needs.add_event<E>();
        add_events(needs.events);
    }

    /// The length of a fixed step in seconds, and how many one frame takes at most; 1/60 and 8 at first. Steps are
    /// counted from here on.
    void set_fixed_step(double seconds, int max_steps = 8);

    /// How many fixed steps were dropped because a frame asked for more than it may take; time that never was for fixed
    /// systems.
    std::uint64_t dropped_steps() const { return fixed_step_.dropped(); }

    /// Runs a frame of `delta_seconds` (0 or more) on `world`, which is the same each time: the frame systems of stage
    /// input; as many fixed steps as the time elapsed asks for, each with all fixed systems stage by stage; the other
    /// frame systems stage by stage. Resource Time says what time it is. The world's own commands are applied first,
    /// and after each exclusive system.
    ///
    /// Removals and events older than the run before this one (or than the step before, as long as no step comes) are
    /// forgotten: a system that looks at them runs every time, or misses some.
    ///
    /// An exception of a system ends the run: no later system begins, and the commands of those that ran beside it are
    /// dropped. Of several exceptions, the one of the earliest system is thrown. It counts as not having run.
    void run(World& world, double delta_seconds = 0);

    /// One entry per system in order, from the last run; 0 ms for a system that has not run in it. Holds until systems
    /// are added.
    std::span<const SystemTime> times() const;

    /// One entry per system, in the order in which they run.
    std::vector<SystemInfo> systems() const;

    /// The names in the order in which the systems run.
    std::vector<std::string_view> names() const;

    /// The pairs of systems of a stage that conflict without being ordered by `before` and `after`, in order.
    std::vector<Ambiguity> ambiguities() const;

private:
    friend class SystemHandle;

    SystemHandle add_system(Stage stage, std::string name, std::unique_ptr<detail::Callable<void>> body);
    void add_events(std::span<const detail::EventType> events);
    void change();
    void plan() const;
    void end_run();
    void run_part(World& world, detail::FramePart part);
    void run_frame(World& world, double delta_seconds);
    void forget(World& world, Tick begin, bool stepped);

    std::vector<std::unique_ptr<detail::SystemEntry>> entries_; ///< in order of registration
    std::vector<detail::EventType> events_;                     ///< each once

    // Follow from the above.
    mutable bool planned_ = true;
    mutable detail::LinearOrder order_;
    mutable detail::Plan plan_;
    mutable std::vector<SystemTime> times_;

    detail::FixedStep fixed_step_;
    double elapsed_before_ = 0; ///< before fixed_step_ began
    std::uint64_t frame_ = 0;
    Tick last_begin_ = 0;      ///< the tick in which the last run began
    Tick last_step_begin_ = 0; ///< the tick in which the last run with a fixed step began
    bool running_ = false;
};

template <class F> SystemHandle& SystemHandle::run_if(F condition) {
    if constexpr (detail::check_condition<F>()) add_condition(detail::make_callable(std::move(condition)));
    return *this;
}

} // namespace hachure
