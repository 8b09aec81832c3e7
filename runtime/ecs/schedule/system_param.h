#pragma once

#include <hachure/runtime/ecs/access.h>
#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/ecs/schedule/term_access.h>
#include <hachure/runtime/ecs/system_context.h>
#include <hachure/runtime/ecs/world.h>

#include <type_traits>
#include <vector>

namespace hachure::detail {

/// What a schedule does for one type of event.
struct EventType {
    TypeId id; ///< of its queue
    void (*ensure)(World& world);
    void (*forget_before)(World& world, Tick tick);
};

/// The parameters of a system, seen from outside.
struct SystemNeeds {
    Access access;
    std::vector<EventType> events;

    template <class E> void add_event() {
        events.push_back({resource_id<EventQueue<E>>(), [](World& world) { event_queue<E>(world); },
                          [](World& world, Tick tick) { event_queue<E>(world).forget_before(tick); }});
    }
};

/// One kind of parameter P: `reads_only`, whether a condition may have it; `add_to`, what it needs; `get`, its value.
template <class P> struct SystemParam;

/// Kinds that are taken by value.
template <class T> inline constexpr bool is_value_param = false;
template <class... Terms> inline constexpr bool is_value_param<Query<Terms...>> = true;
template <class E> inline constexpr bool is_value_param<EventReader<E>> = true;
template <class E> inline constexpr bool is_value_param<EventWriter<E>> = true;
template <class C> inline constexpr bool is_value_param<Removed<C>> = true;
template <> inline constexpr bool is_value_param<LastRun> = true;

template <class R>
concept ResourceParam = std::is_class_v<R> && !std::is_const_v<R> && !is_value_param<R> && !std::is_same_v<R, World> &&
                        !std::is_same_v<R, Commands>;

/// Whether a system can have a parameter P.
template <class P>
concept SystemParameter = requires {
    SystemParam<P>::reads_only;
};

template <class... Terms> struct SystemParam<Query<Terms...>> {
    static constexpr bool reads_only = !Query<Terms...>::writes;
    static void add_to(SystemNeeds& needs) { (TermAccess<Terms>::add_to(needs.access), ...); }
    static Query<Terms...> get(const SystemContext& context) { return context.world.query_at<Terms...>(context.now); }
};

template <ResourceParam R> struct SystemParam<const R&> {
    static constexpr bool reads_only = true;
    static void add_to(SystemNeeds& needs) { needs.access.read_resource<R>(); }
    static const R& get(const SystemContext& context) {
        const World& world = context.world;
        return world.resource<R>();
    }
};

template <ResourceParam R> struct SystemParam<R&> {
    static constexpr bool reads_only = false;
    static void add_to(SystemNeeds& needs) { needs.access.write_resource<R>(); }
    static R& get(const SystemContext& context) { return context.world.resource_mutable<R>(); }
};

template <ResourceParam R> struct SystemParam<const R*> {
    static constexpr bool reads_only = true;
    static void add_to(SystemNeeds& needs) { needs.access.read_resource<R>(); }
    static const R* get(const SystemContext& context) {
        const World& world = context.world;
        return world.find_resource<R>();
    }
};

template <ResourceParam R> struct SystemParam<R*> {
    static constexpr bool reads_only = false;
    static void add_to(SystemNeeds& needs) { needs.access.write_resource<R>(); }
    static R* get(const SystemContext& context) { return context.world.find_resource<R>(); }
};

template <> struct SystemParam<Commands&> {
    static constexpr bool reads_only = false;
    static void add_to(SystemNeeds& needs) { needs.access.commands = true; }
    static Commands& get(const SystemContext& context) { return *context.commands; }
};

template <> struct SystemParam<World&> {
    static constexpr bool reads_only = false;
    static void add_to(SystemNeeds& needs) { needs.access.exclusive = true; }
    static World& get(const SystemContext& context) { return context.world; }
};

template <> struct SystemParam<const World&> {
    static constexpr bool reads_only = true;
    static void add_to(SystemNeeds& needs) { needs.access.reads_world = true; }
    static const World& get(const SystemContext& context) { return context.world; }
};

template <class E> struct SystemParam<EventReader<E>> {
    static constexpr bool reads_only = true;
    static void add_to(SystemNeeds& needs) {
        needs.access.read_resource<EventQueue<E>>();
        needs.add_event<E>();
    }
    static EventReader<E> get(const SystemContext& context) {
        return EventReader<E>(events_since<E>(context.world, context.last));
    }
};

template <class E> struct SystemParam<EventWriter<E>> {
    static constexpr bool reads_only = false;
    static void add_to(SystemNeeds& needs) {
        needs.access.write_resource<EventQueue<E>>();
        needs.add_event<E>();
    }
    static EventWriter<E> get(const SystemContext& context) {
        return {context.world.resource_mutable<EventQueue<E>>(), context.now};
    }
};

template <> struct SystemParam<LastRun> {
    static constexpr bool reads_only = true;
    static void add_to(SystemNeeds&) {}
    static LastRun get(const SystemContext& context) { return {context.last}; }
};

/// Components are lost only while no system of a batch runs, so this contests nothing.
template <class C> struct SystemParam<Removed<C>> {
    static constexpr bool reads_only = true;
    static void add_to(SystemNeeds&) {}
    static Removed<C> get(const SystemContext& context) {
        const World& world = context.world;
        return Removed<C>(world.removed_since<C>(context.last));
    }
};

} // namespace hachure::detail
