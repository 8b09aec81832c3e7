#pragma once

#include <hachure/runtime/animation/pose.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/assets/warning_list.h>

#include <optional>
#include <string>

namespace hachure::animation {

/// A channel that fits its target and whose keys are finite and strictly ascending in time; quaternions are unit. None
/// when nothing of it can be used. `clip` is for messages.
[[nodiscard]] std::optional<assets::AnimationChannel> repair_channel(assets::AnimationChannel channel,
                                                                     const PoseLayout& layout, const std::string& clip,
                                                                     assets::WarningList& warnings);

} // namespace hachure::animation
