#pragma once

#include <hachure/runtime/ecs/type_id.h>

#include <string_view>
#include <vector>

namespace hachure {

/// What a system reads and writes; follows from the types of its parameters. Two systems whose accesses do not conflict
/// may run at the same time.
struct Access {
    /// One type of component or of resource.
    struct Item {
        detail::TypeId id;
        std::string_view name; ///< as the compiler spells it
        bool writes;
    };

    std::vector<Item> components; ///< ascending by id, each once
    std::vector<Item> resources;  ///< the same; a queue of events is a resource
    bool commands = false;        ///< queues commands, and so takes handles of new entities from the world
    bool reads_world = false;     ///< may read any component and resource
    bool exclusive = false;       ///< may do anything

    template <class C> void read_component() { add(components, item<C>(detail::component_id<C>(), false)); }
    template <class C> void write_component() { add(components, item<C>(detail::component_id<C>(), true)); }
    template <class R> void read_resource() { add(resources, item<R>(detail::resource_id<R>(), false)); }
    template <class R> void write_resource() { add(resources, item<R>(detail::resource_id<R>(), true)); }

    /// Becomes the access of one that does both.
    void merge(const Access& other);

    /// Whether it changes anything, commands included.
    bool writes() const;

private:
    template <class T> static Item item(detail::TypeId id, bool writes) { return {id, detail::type_name<T>(), writes}; }
    static void add(std::vector<Item>& items, const Item& added);
};

/// Whether one writes what the other reads or writes. Those that queue commands conflict, too: which handles their new
/// entities get depends on who comes first. An exclusive access conflicts with every other.
bool conflicts(const Access& a, const Access& b);

/// The names of what they conflict on, in alphabetical order: types, and "Commands" and "World"; empty when they do not
/// conflict.
std::vector<std::string_view> contested(const Access& a, const Access& b);

} // namespace hachure
