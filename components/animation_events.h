#pragma once

#include <hachure/runtime/animation/timeline_events.h>
#include <hachure/runtime/ecs/entity.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace hachure {

/// What happens at moments of a model's clips: each time one is passed, a ClipEvent is sent.
struct AnimationEvents {
    std::map<std::string, std::vector<animation::TimelineEvent>, std::less<>> by_clip; ///< sorted; see sort_events
};

/// A moment of a clip was passed. Read with EventReader<ClipEvent>.
struct ClipEvent {
    Entity model; ///< the root that plays the clip
    std::string clip;
    std::string name;  ///< of the event
    double time = 0.0; ///< seconds of the clip
};

} // namespace hachure
