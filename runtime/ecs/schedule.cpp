#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/ecs/schedule/run_batch.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>

namespace hachure {
namespace {

void set_time(World& world, const Time& time) {
    if (Time* found = world.find_resource<Time>())
        *found = time;
    else
        world.set_resource(time);
}

/// By place: which systems of the order an explicit chain leads to.
std::vector<std::vector<bool>> reachable(const detail::LinearOrder& order) {
    const std::size_t count = order.systems.size();
    std::vector<std::vector<bool>> result(count, std::vector<bool>(count));
    for (std::size_t place = count; place-- > 0;)
        for (const std::uint32_t follower : order.followers[place]) {
            result[place][follower] = true;
            for (std::size_t i = follower; i < count; ++i)
                if (result[follower][i]) result[place][i] = true;
        }
    return result;
}

} // namespace

SystemHandle& SystemHandle::before(std::string name) {
    schedule_->change();
    entry_->before.push_back(std::move(name));
    return *this;
}

SystemHandle& SystemHandle::after(std::string name) {
    schedule_->change();
    entry_->after.push_back(std::move(name));
    return *this;
}

SystemHandle& SystemHandle::fixed() {
    schedule_->change();
    entry_->fixed = true;
    return *this;
}

SystemHandle& SystemHandle::add_condition(std::unique_ptr<detail::Callable<bool>> condition) {
    schedule_->change();
    const detail::SystemNeeds needs = condition->needs();
    entry_->access.merge(needs.access);
    schedule_->add_events(needs.events);
    entry_->conditions.push_back(std::move(condition));
    return *this;
}

SystemHandle Schedule::add_system(Stage stage, std::string name, std::unique_ptr<detail::Callable<void>> body) {
    change();
    const auto same_name = [&name](const auto& entry) { return entry->name == name; };
    HACHURE_ASSERT(std::ranges::none_of(entries_, same_name), "a system's name is its own");
    const detail::SystemNeeds needs = body->needs();
    add_events(needs.events);
    entries_.push_back(std::make_unique<detail::SystemEntry>(
        detail::SystemEntry{stage, std::move(name), std::move(body), needs.access}));
    return {*this, *entries_.back()};
}

void Schedule::add_events(std::span<const detail::EventType> events) {
    for (const detail::EventType& event : events)
        if (std::ranges::find(events_, event.id, &detail::EventType::id) == events_.end()) events_.push_back(event);
}

void Schedule::change() {
    HACHURE_ASSERT(!running_, "systems are added between runs");
    planned_ = false;
}

void Schedule::set_fixed_step(double seconds, int max_steps) {
    HACHURE_ASSERT(!running_, "the fixed step changes between runs");
    elapsed_before_ += fixed_step_.elapsed();
    fixed_step_ = detail::FixedStep(seconds, max_steps);
}

void Schedule::plan() const {
    if (planned_) return;
    order_ = detail::linear_order(entries_);
    plan_ = detail::make_plan(order_);
    times_.clear();
    for (const detail::SystemEntry* system : order_.systems) times_.push_back({system->name, system->stage, 0.0});
    planned_ = true;
}

void Schedule::run(World& world, double delta_seconds) {
    HACHURE_ASSERT(!running_, "a system does not run its own schedule");
    plan();

    running_ = true;
    for (detail::SystemEntry* system : order_.systems) system->ms = 0;
    // No object that ends the run in its destructor: g++ 12 loses the destructor's writes where an exception passes.
    try {
        run_frame(world, delta_seconds);
    } catch (...) {
        end_run();
        throw;
    }
    end_run();
}

void Schedule::end_run() {
    running_ = false;
    for (std::size_t i = 0; i < times_.size(); ++i) times_[i].ms = order_.systems[i]->ms;
}

void Schedule::run_frame(World& world, double delta_seconds) {
    for (const detail::EventType& event : events_) event.ensure(world);
    world.apply_commands();

    const Tick begin = world.tick();
    const int steps = fixed_step_.advance(delta_seconds);
    const Time frame{.delta = delta_seconds,
                     .elapsed = elapsed_before_ + fixed_step_.elapsed(),
                     .frame = frame_++,
                     .step_fraction = fixed_step_.fraction()};
    set_time(world, frame);
    run_part(world, detail::FramePart::input);
    for (int left = steps; left-- > 0;) {
        const double step = fixed_step_.seconds();
        const double end = static_cast<double>(fixed_step_.taken() - static_cast<std::uint64_t>(left)) * step;
        set_time(world, {.delta = step, .elapsed = end, .frame = frame.frame});
        run_part(world, detail::FramePart::fixed);
    }
    set_time(world, frame);
    run_part(world, detail::FramePart::frame);
    forget(world, begin, steps > 0);
}

void Schedule::run_part(World& world, detail::FramePart part) {
    for (const detail::Batch& batch : plan_[static_cast<std::size_t>(part)]) detail::run_batch(world, batch);
}

void Schedule::forget(World& world, Tick begin, bool stepped) {
    // A system that last ran in the run before this one asked in a tick no earlier than last_begin_; a fixed one that
    // last ran in the last run with a step, in one no earlier than last_step_begin_.
    const bool has_fixed = !plan_[static_cast<std::size_t>(detail::FramePart::fixed)].empty();
    const Tick oldest = has_fixed ? std::min(last_begin_, last_step_begin_) : last_begin_;
    world.forget_removed_before(oldest);
    for (const detail::EventType& event : events_) event.forget_before(world, oldest);
    last_begin_ = begin;
    if (stepped) last_step_begin_ = begin;
}

std::span<const SystemTime> Schedule::times() const {
    plan();
    return times_;
}

std::vector<SystemInfo> Schedule::systems() const {
    plan();
    std::vector<SystemInfo> result;
    for (const detail::SystemEntry* system : order_.systems)
        result.push_back({system->name, system->stage, system->access});
    return result;
}

std::vector<std::string_view> Schedule::names() const {
    plan();
    std::vector<std::string_view> result;
    for (const detail::SystemEntry* system : order_.systems) result.push_back(system->name);
    return result;
}

std::vector<Ambiguity> Schedule::ambiguities() const {
    plan();
    const std::vector<std::vector<bool>> ordered = reachable(order_);
    std::vector<Ambiguity> result;
    for (std::size_t i = 0; i < order_.systems.size(); ++i)
        for (std::size_t j = i + 1; j < order_.systems.size(); ++j) {
            const detail::SystemEntry& first = *order_.systems[i];
            const detail::SystemEntry& second = *order_.systems[j];
            if (!detail::same_place(first, second)) break;
            if (ordered[i][j] || !conflicts(first.access, second.access)) continue;
            result.push_back({first.name, second.name, first.stage, contested(first.access, second.access)});
        }
    return result;
}

} // namespace hachure
