#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace hachure {

/// What an entity can carry: a movable struct or class. One that can be copied can be instantiated; a type that only
/// looks as if (`std::vector<std::unique_ptr<T>>` does) deletes its copy constructor.
template <class C>
concept Component = std::is_class_v<C> && std::movable<C> && std::same_as<C, std::remove_cvref_t<C>>;

/// How a world keeps a component type. A type chooses with a member: `static constexpr auto storage = Storage::sparse;`
enum class Storage : std::uint8_t {
    table,  ///< beside the entity's other components, in packed columns: walked like plain arrays. The default.
    sparse, ///< in a column of its own: added and removed without touching the other components. For tags and marks
            ///< that come and go all the time.
};

/// The storage of C.
template <class C> inline constexpr Storage storage_of = Storage::table;
template <class C>
requires std::same_as<decltype((C::storage)), const Storage&>
inline constexpr Storage storage_of<C> = C::storage;

namespace detail {
/// Whether C... names no type twice.
template <class... C> inline constexpr bool distinct = true;
template <class First, class... Rest>
inline constexpr bool distinct<First, Rest...> = (!std::is_same_v<First, Rest> && ...) && distinct<Rest...>;

template <class C> inline constexpr bool is_sparse = storage_of<std::remove_const_t<C>> == Storage::sparse;

/// Bytes from one component of a column to the next. Empty types take no room: all share one address.
template <class C> inline constexpr std::uint32_t stride_of = std::is_empty_v<C> ? 0 : sizeof(C);
} // namespace detail

} // namespace hachure
