#pragma once

#include <hachure/components/name_index.h>
#include <hachure/runtime/ecs/world.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hachure {

/// The entities below one, by what they are called: as NameIndex finds them, but none outside, and as they were when it
/// was made.
class NamesBelow {
public:
    NamesBelow(const World& world, Entity root);

    /// The first in the order of the tree that is called so, or null.
    [[nodiscard]] Entity find(const World& world, std::string_view path) const;

private:
    Entity root_;
    std::unordered_multimap<std::string, std::size_t> by_name_; ///< place in below_
    std::vector<Entity> below_;
};

/// The first entity of the world that is called so, those at and below `scope` before all others; null for none.
[[nodiscard]] Entity find_within(const NameIndex& index, const World& world, std::string_view path, Entity scope);

} // namespace hachure
