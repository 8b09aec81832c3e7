#pragma once

#include <hachure/components/animation.h>
#include <hachure/components/animation_events.h>
#include <hachure/components/animation_layers.h>
#include <hachure/components/animation_states.h>
#include <hachure/components/root_motion.h>
#include <hachure/systems/animation/clip_mix.h>

#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// What the components of a model's root ask to be played; all but one of the first two may be null.
struct PlayRequest {
    const Animation* animation = nullptr;
    const AnimationStates* states = nullptr;
    const AnimationLayers* layers = nullptr;
    const RootMotion* root_motion = nullptr;
};

/// Plays one model: keeps what was shown, so that changes fade and nothing is done twice.
class ModelPlayer {
public:
    /// Moves on by `delta` seconds. False when the pose stays as it is; else `mix` is to be run, and `animation`,
    /// `states` and `layers` are what the components become. Names that the model does not know are said in `warnings`.
    bool advance(const PlayRequest& request, const ModelClips& clips, double delta, std::vector<std::string>& warnings);

    /// Sends what was passed on the way.
    void collect_events(Entity model, const ModelClips& clips, const AnimationEvents& events,
                        std::vector<ClipEvent>& passed);

    ClipMix mix;
    animation::Pose shown; ///< what was written to the model's entities
    Animation animation;
    AnimationStates states;
    AnimationLayers layers;

private:
    std::int32_t find(const ModelClips& clips, std::string_view name, std::vector<std::string>& warnings) const;
    bool advance_animation(const Animation& wanted, const ModelClips& clips, double delta,
                           std::vector<std::string>& warnings);
    bool advance_states(const AnimationStates& wanted, const Animation* pace, const ModelClips& clips, double delta);
    bool advance_layers(const AnimationLayers& wanted, const ModelClips& clips, double delta,
                        std::vector<std::string>& warnings);
    void begin_fade(const Animation& wanted);
    void set_root_motion(const RootMotion* wanted, const ModelClips& clips, std::vector<std::string>& warnings);

    bool started_ = false;
    ClipSource current_, fading_; ///< `fading_` plays on while it fades out
    double fade_length_ = 0.0, fade_time_ = 0.0;
    RootMotion root_motion_;
    bool has_root_motion_ = false;
    std::vector<animation::PassedEvent> passed_;
};

} // namespace hachure
