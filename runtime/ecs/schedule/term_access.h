#pragma once

#include <hachure/runtime/ecs/access.h>
#include <hachure/runtime/ecs/query/query_terms.h>

#include <type_traits>

namespace hachure::detail {

/// What a term of a query reads and writes: `static void add_to(Access&)`. A kind of term that is no component
/// specialises it. T itself is a component, const or not.
template <class T> struct TermAccess {
    static void add_to(Access& access) {
        if constexpr (std::is_const_v<T>)
            access.read_component<std::remove_const_t<T>>();
        else
            access.write_component<T>();
    }
};

template <class T> struct TermAccess<Optional<T>> : TermAccess<T> {};

/// Who has a component changes only while no query is walked, so asking for that contests nothing.
template <class... T> struct TermAccess<With<T...>> {
    static void add_to(Access&) {}
};
template <class... T> struct TermAccess<Without<T...>> {
    static void add_to(Access&) {}
};

template <class... T> struct TermAccess<AnyOf<T...>> {
    static void add_to(Access& access) { (TermAccess<T>::add_to(access), ...); }
};

template <class T> struct TermAccess<OfParent<T>> {
    static void add_to(Access& access) {
        access.read_component<Parent>();
        access.read_component<std::remove_const_t<T>>();
    }
};

} // namespace hachure::detail
