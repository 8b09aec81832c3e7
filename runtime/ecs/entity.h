#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace hachure {

/// A handle to one entity of a `World`: a slot, and how often that slot has been given out. A handle outlives what it
/// names: after `World::destroy` it is dead for good, also when its slot is used again. Handles of one world mean
/// nothing in another.
struct Entity {
    std::uint32_t index = 0xffff'ffffu; ///< slot in the world
    std::uint32_t generation = 0;       ///< 1 for the first entity of a slot, one more for each that follows

    /// Names no entity; what a default-constructed handle is.
    static const Entity null;

    /// True unless null. Says nothing about being alive: ask `World::alive`.
    explicit constexpr operator bool() const { return index != 0xffff'ffffu; }

    friend constexpr bool operator==(const Entity&, const Entity&) = default;
    friend constexpr auto operator<=>(const Entity&, const Entity&) = default;
};

inline constexpr Entity Entity::null{};

/// For messages: "12v3" is slot 12, generation 3; "null" is null.
std::string to_string(Entity entity);

} // namespace hachure

template <> struct std::hash<hachure::Entity> {
    std::size_t operator()(const hachure::Entity& entity) const noexcept {
        return std::hash<std::uint64_t>{}(std::uint64_t{entity.generation} << 32 | entity.index);
    }
};
