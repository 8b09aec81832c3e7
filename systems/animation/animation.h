#pragma once

#include <cstdint>

namespace hachure {

class App;

/// What the last frame sampled. A resource.
struct AnimationCounts {
    std::uint64_t models = 0; ///< that got a new pose
    std::uint64_t clips = 0;  ///< that were sampled for them
};

/// Models with clips (Rig) play them: Animation or AnimationStates choose what, AnimationLayers lie over it, RootMotion
/// moves the model, AnimationEvents are sent. A model that is paused or has nothing to play costs nothing.
void register_animation(App& app);

} // namespace hachure
