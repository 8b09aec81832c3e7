#pragma once

#include <hachure/runtime/ecs/schedule/schedule_plan.h>

namespace hachure::detail {

/// Runs the systems of a batch whose conditions hold, each in a tick of its own: the world's current tick for the first
/// and one more for each after it. Their commands are applied in a further tick; those of an exclusive system, which is
/// alone, in its own, followed by the world's own. The world's tick ends up behind all of these.
///
/// An exception of a system keeps later ones from beginning; all commands of the batch are dropped, and the exception
/// of the earliest system is rethrown.
void run_batch(World& world, const Batch& batch);

} // namespace hachure::detail
