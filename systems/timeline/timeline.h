#pragma once

#include <cstdint>

namespace hachure {

class App;

/// What timelines did in the last frame. A resource.
struct TimelineCounts {
    std::uint64_t timelines = 0; ///< that moved on
    std::uint64_t tracks = 0;    ///< that were sampled
    std::uint64_t written = 0;   ///< fields that got another value
    std::uint64_t actions = 0;   ///< that were done
    std::uint64_t searched = 0;  ///< targets that were looked for by name
};

/// Entities with a Timeline play it, before scripts run: actions that were passed, in order, then tracks, then paths,
/// then what looks at something. A timeline that is paused or over changes nothing. Scene files say it as "timeline".
void register_timeline(App& app);

} // namespace hachure
