#pragma once

#include <hachure/runtime/animation/blend.h>
#include <hachure/runtime/animation/playback.h>
#include <hachure/runtime/animation/root_motion.h>
#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/runtime/scene/clip_store.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace hachure {

/// A clip that plays for a weight. Times are playing times.
struct ClipSource {
    std::int32_t clip = -1; ///< into the ClipSet; -1 for the rest pose
    animation::Playback playback;
    double previous = animation::not_started; ///< before this frame
    double time = 0.0;
    float weight = 1.0f; ///< at least 0
};

/// A clip over others; see AnimationLayer.
struct LayerSource {
    ClipSource source;
    bool additive = false;
    std::vector<float> mask; ///< per node; empty for all
};

/// What a model plays at a moment, and the pose that comes out. Memory is kept from frame to frame.
struct ClipMix {
    std::vector<ClipSource> sources;
    std::vector<LayerSource> layers;
    std::optional<animation::RootMotionOptions> root_motion;

    animation::Pose pose;          ///< out
    animation::RigidMotion motion; ///< out: of the root joint since the frame before, in its parent's space
    std::vector<float> pointers;   ///< out: values of the pointers of the first source's clip

    /// Samples and blends. Every model has its own ClipMix, so that many run at once.
    void run(const ModelClips& clips);

private:
    void sample(const ModelClips& clips, const ClipSource& source, animation::SampleCache& cache, animation::Pose& into,
                bool with_pointers);
    void take_motion_out(const ModelClips& clips);
    void lay_over(const ModelClips& clips);

    std::vector<animation::Pose> poses_;         ///< by source
    std::vector<animation::SampleCache> caches_; ///< by source, then by layer
    animation::Pose layer_pose_, reference_;
    animation::SampleCache reference_cache_;
};

} // namespace hachure
