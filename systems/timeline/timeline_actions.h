#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/systems/timeline/timeline_targets.h>
#include <hachure/systems/timeline/warn_once.h>

namespace hachure {

/// What the actions of one timeline work on.
struct TimelineStageHands {
    World& world;
    TimelineTargets& targets; ///< up to date
    WarnOnce& warnings;
    Entity carrier; ///< of the timeline
};

/// Does an action. Whom it names and is not there is a warning, as is a file that can't be spawned.
void do_action(const TimelineStageHands& hands, const TimelineAction& action);

} // namespace hachure
