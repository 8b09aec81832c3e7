#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <utility>

namespace hachure {

/// Events of type E in order of sending, newest last. Holds until they are forgotten; events sent while it is walked
/// are not part of it, and do not disturb it.
template <class E> class EventRange {
public:
    class Iterator;

    EventRange() = default;
    EventRange(const std::deque<E>& events, std::size_t first)
        : events_(&events), first_(first), last_(events.size()) {}

    Iterator begin() const { return {events_, first_}; }
    Iterator end() const { return {events_, last_}; }
    std::size_t size() const { return last_ - first_; }
    bool empty() const { return first_ == last_; }

private:
    const std::deque<E>* events_ = nullptr;
    std::size_t first_ = 0;
    std::size_t last_ = 0;
};

/// Walks events by number, which sending more does not invalidate.
template <class E> class EventRange<E>::Iterator {
public:
    using value_type = E;
    using reference = const E&;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;

    Iterator() = default;
    Iterator(const std::deque<E>* events, std::size_t at) : events_(events), at_(at) {}

    const E& operator*() const { return (*events_)[at_]; }
    const E* operator->() const { return &(*events_)[at_]; }
    Iterator& operator++() {
        ++at_;
        return *this;
    }
    Iterator operator++(int) { return std::exchange(*this, {events_, at_ + 1}); }
    bool operator==(const Iterator&) const = default;

private:
    const std::deque<E>* events_ = nullptr;
    std::size_t at_ = 0;
};

/// Resource: the events of one type that were sent and not yet forgotten. Systems use EventWriter and EventReader.
template <class E> class EventQueue {
public:
    /// `now` is never less than at the call before.
    void send(E event, Tick now) {
        HACHURE_ASSERT(ticks_.empty() || ticks_.back() <= now, "events are sent in order of time");
        ticks_.push_back(now);
        events_.push_back(std::move(event));
    }

    /// The events sent after tick `since`.
    EventRange<E> since(Tick since) const {
        return {events_, static_cast<std::size_t>(std::ranges::upper_bound(ticks_, since) - ticks_.begin())};
    }

    /// Forgets events sent before `tick`.
    void forget_before(Tick tick) {
        while (!ticks_.empty() && ticks_.front() < tick) {
            ticks_.pop_front();
            events_.pop_front();
        }
    }

    std::size_t size() const { return events_.size(); }

private:
    std::deque<E> events_;
    std::deque<Tick> ticks_; ///< ascending, parallel to events_
};

/// System parameter: sends events of type E. Systems that send or read the same E run one after another.
template <class E> class EventWriter {
public:
    EventWriter(EventQueue<E>& queue, Tick now) : queue_(&queue), now_(now) {}

    void send(E event) { queue_->send(std::move(event), now_); }

private:
    EventQueue<E>* queue_;
    Tick now_;
};

/// System parameter: the events that others sent since the system last ran, each exactly once, in order of sending; a
/// range of `const E&`.
template <class E> class EventReader : public EventRange<E> {
public:
    using EventRange<E>::EventRange;
    explicit EventReader(EventRange<E> range) : EventRange<E>(range) {}
};

/// The world's queue of E, made when absent.
template <class E> EventQueue<E>& event_queue(World& world) {
    EventQueue<E>* queue = world.find_resource<EventQueue<E>>();
    return queue ? *queue : world.set_resource(EventQueue<E>{});
}

/// Sends an event in the world's current tick; for programs and exclusive systems.
template <class E> void send_event(World& world, E event) {
    event_queue<E>(world).send(std::move(event), world.tick());
}

/// The events sent after tick `since` that are not yet forgotten; see `Schedule::run`. Holds until then.
template <class E> EventRange<E> events_since(const World& world, Tick since) {
    const EventQueue<E>* queue = world.find_resource<EventQueue<E>>();
    return queue ? queue->since(since) : EventRange<E>{};
}

} // namespace hachure
