#pragma once

#include <hachure/runtime/ecs/world.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hachure {

/// Finds the entities of one world by what they are called: by a Name, or by a path of names from some ancestor down,
/// "car/wheel/rim". A name that holds a '/' itself is found all the same. Names may repeat; matches come in the order
/// of the tree: an entity before those below it, siblings in their order, roots in order of their slots.
class NameIndex {
public:
    /// Takes in what changed since the last call, and costs as much. Every call is for the same world, which may have
    /// been moved in between.
    void update(const World& world);

    /// The first match, or null. What happened to the world after `update` may be missed, but what is found is right.
    [[nodiscard]] Entity find(const World& world, std::string_view path) const;

    /// The first match below `root` (not itself), or null. Costs as many steps as there are entities below or, where
    /// they are fewer, matches.
    [[nodiscard]] Entity find_below(const World& world, Entity root, std::string_view path) const;

    /// All matches.
    [[nodiscard]] std::vector<Entity> find_all(const World& world, std::string_view path) const;

private:
    /// Lets the map be searched without making a string.
    struct Hash : std::hash<std::string_view> {
        using is_transparent = void;
    };

    /// Where an entity is listed.
    struct Listing {
        const std::string* name; ///< the key in by_name_
        std::size_t position;    ///< in the list there
    };

    /// All matches, in any order.
    [[nodiscard]] std::vector<Entity> matches(const World& world, std::string_view path) const;
    void insert(Entity entity, const std::string& name);
    void erase(Entity entity);

    std::unordered_map<std::string, std::vector<Entity>, Hash, std::equal_to<>> by_name_;
    std::unordered_map<Entity, Listing> listings_;
    Tick seen_ = 0; ///< all changes up to this tick are in the index
};

} // namespace hachure
