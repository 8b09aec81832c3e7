#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/assets/json_value.h>
#include <hachure/runtime/ecs/reflect.h>

#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hachure {

/// A timeline that is being read.
struct TimelineReading {
    const TypeRegistry& types;
    std::vector<std::string>& warnings;
    TimelineDocument document;
    double last = 0.0; ///< the latest time of anything so far, seconds

    /// The place of an entity's path among the document's targets, which it is added to.
    std::uint32_t target(const std::string& path);

    std::size_t keys = 0;                                                 ///< of tracks and paths so far
    std::unordered_map<std::string, std::uint32_t> targets;               ///< places by path
    std::set<std::tuple<std::uint32_t, std::string, std::int32_t>> moved; ///< target, component.field, element
};

// Each throws Error with the place of what is wrong.

/// A time of a key, an action or a point.
[[nodiscard]] double read_time(TimelineReading& reading, const assets::JsonValue& value);

/// Adds to the document what an element of "tracks" says.
void read_track(TimelineReading& reading, const assets::JsonValue& value);

/// The same for "paths".
void read_path(TimelineReading& reading, const assets::JsonValue& value);

/// What an element of "actions" says, and when.
[[nodiscard]] std::pair<double, TimelineAction> read_action(TimelineReading& reading, const assets::JsonValue& value);

/// Counts keys; too many are a fault.
void count_keys(TimelineReading& reading, const assets::JsonValue& value, std::size_t keys);

} // namespace hachure
