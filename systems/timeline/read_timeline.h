#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/assets/json_value.h>
#include <hachure/runtime/ecs/reflect.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace hachure {

/// What a timeline in a file may have at most.
inline constexpr std::size_t most_timeline_tracks = 100'000, most_timeline_keys = 4'000'000,
                             most_timeline_actions = 100'000;

/// Reads a timeline (docs/timelines.md). Throws Error with line and column for everything that it does not understand:
/// keys of objects, components and fields that do not exist, values that a field can't hold, times out of order.
/// `folder` is what `{"file": ...}` is relative to, and can't leave. Oddities are said in `warnings`.
[[nodiscard]] std::shared_ptr<const TimelineDocument> read_timeline(const assets::JsonValue& value,
                                                                    const TypeRegistry& types,
                                                                    const std::filesystem::path& folder,
                                                                    std::vector<std::string>& warnings);

} // namespace hachure
