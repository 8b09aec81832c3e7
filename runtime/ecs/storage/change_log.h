#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/tick.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace hachure::detail {

/// What changed of one component type: the entities, while they are few; only when, once they are many. The queue is
/// what makes looking for ten changes among a million entities cost ten steps; past a few percent of them, sweeping
/// over all ticks is cheaper (`bench ecs` measures where), and the queue is given up until the next tick.
class ChangeLog {
public:
    struct Entry {
        Entity entity;
        Tick tick;
    };

    /// When anything was last added, changed or removed; 0 for never.
    Tick last_changed() const { return last_changed_; }

    /// `entity` was changed, for the first time in tick `now`; ticks never go back.
    void note(Entity entity, Tick now) {
        last_changed_ = now;
        if (complete_since_ < now) push(entity, now);
    }

    /// So many were changed that they are not worth listing.
    void note_many(Tick now) {
        last_changed_ = complete_since_ = now;
        entries_.clear();
    }

    /// `entity` got the component.
    void note_added(Entity entity, Tick now) {
        ++population_;
        note(entity, now);
    }

    /// All of these did.
    void note_many_added(std::span<const Entity> entities, Tick now) {
        population_ += entities.size();
        if (entities.size() > smallest_limit) return note_many(now);
        for (const Entity entity : entities) note(entity, now);
    }

    /// `count` entities lost it.
    void note_removed(std::size_t count, Tick now) {
        population_ -= count;
        last_changed_ = now;
    }

    /// Takes back what was noted of `entity` in tick `now`, so that no tick has an entity twice.
    void forget(Entity entity, Tick now);

    /// Whether `since` can be asked: every change after `since` is listed.
    bool complete_since(Tick since) const { return complete_since_ <= since; }

    /// The changes after `since`, in order of time; an entity stands there once for each tick in which it changed.
    /// `complete_since(since)` holds.
    std::span<const Entry> since(Tick since) const;

    /// How many entities carry the component.
    std::size_t population() const { return population_; }

    /// How many entries the queue may have.
    std::size_t limit() const { return std::max(smallest_limit, population_ / largest_share); }

private:
    void push(Entity entity, Tick now);

    static constexpr std::size_t smallest_limit = 256;
    static constexpr std::size_t largest_share = 16;

    Tick last_changed_ = 0;
    Tick complete_since_ = 0;
    std::vector<Entry> entries_; ///< in order of time; every change after complete_since_
    std::size_t population_ = 0;
};

} // namespace hachure::detail
