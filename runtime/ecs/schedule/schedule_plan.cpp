#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/schedule/schedule_plan.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>

namespace hachure::detail {
namespace {

using Followers = std::vector<std::vector<std::uint32_t>>;

auto place_of(const SystemEntry& system) { return std::tuple(frame_part(system), system.stage); }

void assert_stages_agree(const SystemEntry& earlier, const SystemEntry& later) {
    const std::string message = "the order of systems follows their stages: '" + earlier.name +
                                "' cannot run before '" + later.name + "', of an earlier stage or step";
    HACHURE_ASSERT(place_of(earlier) <= place_of(later), message.c_str());
}

/// The explicit order between systems of one place, by number.
class ExplicitOrder {
public:
    explicit ExplicitOrder(std::span<SystemEntry* const> systems) : systems_(systems), followers_(systems.size()) {
        std::unordered_map<std::string_view, std::uint32_t> numbers;
        for (std::uint32_t i = 0; i < systems.size(); ++i) numbers.emplace(systems[i]->name, i);
        for (std::uint32_t i = 0; i < systems.size(); ++i) {
            for (const std::string& name : systems[i]->before)
                if (const auto found = numbers.find(name); found != numbers.end()) add(i, found->second);
            for (const std::string& name : systems[i]->after)
                if (const auto found = numbers.find(name); found != numbers.end()) add(found->second, i);
        }
        for (auto& followers : followers_) {
            std::ranges::sort(followers);
            const auto repeated = std::ranges::unique(followers);
            followers.erase(repeated.begin(), repeated.end());
        }
    }

    const Followers& followers() const { return followers_; }

private:
    void add(std::uint32_t earlier, std::uint32_t later) {
        assert_stages_agree(*systems_[earlier], *systems_[later]);
        if (same_place(*systems_[earlier], *systems_[later])) followers_[earlier].push_back(later);
    }

    std::span<SystemEntry* const> systems_;
    Followers followers_;
};

/// What is left when a cycle stops the sort; "a -> b -> a" is one cycle of it.
std::string describe_cycle(std::span<SystemEntry* const> systems, const Followers& followers,
                           const std::vector<bool>& done) {
    const auto predecessor = [&](std::uint32_t system) {
        for (std::uint32_t i = 0; i < systems.size(); ++i)
            if (!done[i] && std::ranges::binary_search(followers[i], system)) return i;
        return system;
    };
    std::vector<std::uint32_t> trail; // backwards, until a system comes again
    auto at = static_cast<std::uint32_t>(std::ranges::find(done, false) - done.begin());
    while (std::ranges::find(trail, at) == trail.end()) {
        trail.push_back(at);
        at = predecessor(at);
    }
    std::string cycle = "'" + systems[at]->name + "'";
    while (trail.back() != at) {
        cycle += " -> '" + systems[trail.back()]->name + "'";
        trail.pop_back();
    }
    return "the order of systems has no cycle: " + cycle + " -> '" + systems[at]->name + "'";
}

/// The numbers of the systems in linear order. Their count is small, so what is ready is looked for each time.
std::vector<std::uint32_t> sorted(std::span<SystemEntry* const> systems, const Followers& followers) {
    std::vector<std::uint32_t> waits_for(systems.size());
    for (const auto& list : followers)
        for (const std::uint32_t follower : list) ++waits_for[follower];
    std::vector<bool> done(systems.size());
    std::vector<std::uint32_t> order;
    while (order.size() < systems.size()) {
        std::uint32_t next = 0;
        while (next < systems.size() && (done[next] || waits_for[next] > 0)) ++next;
        // Places come one after another, and a cycle is always within one: do not pass it by.
        const std::uint32_t first_open = static_cast<std::uint32_t>(std::ranges::find(done, false) - done.begin());
        if (next == systems.size() || !same_place(*systems[next], *systems[first_open])) {
            const std::string message = describe_cycle(systems, followers, done);
            HACHURE_ASSERT(false, message.c_str());
        }
        done[next] = true;
        order.push_back(next);
        for (const std::uint32_t follower : followers[next]) --waits_for[follower];
    }
    return order;
}

bool follows_explicitly(const LinearOrder& order, std::uint32_t earlier, std::uint32_t later) {
    return std::ranges::binary_search(order.followers[earlier], later);
}

/// Whether the system at `place` must begin a batch after the one of those from `begin` on.
bool cuts(const LinearOrder& order, std::uint32_t begin, std::uint32_t place) {
    const SystemEntry& system = *order.systems[place];
    const SystemEntry& previous = *order.systems[place - 1];
    if (!same_place(system, previous) || system.access.exclusive || previous.access.exclusive) return true;
    // Whoever asks to come after a system that queues commands wants to see them applied.
    for (std::uint32_t i = begin; i < place; ++i)
        if (order.systems[i]->access.commands && follows_explicitly(order, i, place)) return true;
    return false;
}

Batch make_batch(const LinearOrder& order, std::uint32_t begin, std::uint32_t end) {
    Batch batch;
    for (std::uint32_t place = begin; place < end; ++place) {
        SystemEntry* system = order.systems[place];
        const std::uint32_t task = batch.graph.add_task();
        for (std::uint32_t i = 0; i < task; ++i)
            if (follows_explicitly(order, begin + i, place) || conflicts(batch.systems[i]->access, system->access))
                batch.graph.add_order(i, task);
        batch.systems.push_back(system);
    }
    return batch;
}

} // namespace

FramePart frame_part(const SystemEntry& system) {
    if (system.fixed) return FramePart::fixed;
    return system.stage == Stage::input ? FramePart::input : FramePart::frame;
}

bool same_place(const SystemEntry& a, const SystemEntry& b) { return place_of(a) == place_of(b); }

LinearOrder linear_order(std::span<const std::unique_ptr<SystemEntry>> systems) {
    std::vector<SystemEntry*> by_place;
    for (const auto& system : systems) by_place.push_back(system.get());
    std::ranges::stable_sort(by_place, {}, [](const SystemEntry* system) { return place_of(*system); });

    const ExplicitOrder explicit_order(by_place);
    const std::vector<std::uint32_t> numbers = sorted(by_place, explicit_order.followers());
    std::vector<std::uint32_t> places(numbers.size());
    for (std::uint32_t place = 0; place < numbers.size(); ++place) places[numbers[place]] = place;

    LinearOrder order;
    for (const std::uint32_t number : numbers) {
        order.systems.push_back(by_place[number]);
        auto& followers = order.followers.emplace_back();
        for (const std::uint32_t follower : explicit_order.followers()[number]) followers.push_back(places[follower]);
        std::ranges::sort(followers);
    }
    return order;
}

Plan make_plan(const LinearOrder& order) {
    Plan plan;
    const auto count = static_cast<std::uint32_t>(order.systems.size());
    for (std::uint32_t begin = 0, place = 1; begin < count; ++place) {
        if (place < count && !cuts(order, begin, place)) continue;
        const auto part = static_cast<std::size_t>(frame_part(*order.systems[begin]));
        plan[part].push_back(make_batch(order, begin, place));
        begin = place;
    }
    return plan;
}

} // namespace hachure::detail
