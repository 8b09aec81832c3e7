#pragma once

#include <hachure/runtime/ecs/world.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace hachure {

/// What the parts of an entity were read from, beside what they would have been written as right then. Their author's
/// own way of saying it is written again as long as nothing has changed.
struct PartSources {
    struct Source {
        nlohmann::json said, meant;
    };
    std::map<std::string, Source, std::less<>> by_part;
};

/// Remembers what a part was read from; `meant` is how it is written otherwise.
inline void remember_source(World& world, Entity entity, std::string_view part, nlohmann::json said,
                            nlohmann::json meant) {
    if (!world.has<PartSources>(entity)) world.add(entity, PartSources{});
    world.get_mutable<PartSources>(entity).by_part[std::string(part)] = {std::move(said), std::move(meant)};
}

/// As it was read, if it would still be written as `meant`; else that.
inline nlohmann::json as_it_was(const World& world, Entity entity, std::string_view part, nlohmann::json meant) {
    const PartSources* sources = world.find<PartSources>(entity);
    if (!sources) return meant;
    const auto source = sources->by_part.find(part);
    return source != sources->by_part.end() && source->second.meant == meant ? source->second.said : meant;
}

/// A float as few digits say it: 0.1, and not 0.10000000149011612.
nlohmann::json shortest_number(float number);

} // namespace hachure
