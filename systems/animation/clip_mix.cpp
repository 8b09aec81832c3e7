#include <hachure/systems/animation/clip_mix.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hachure {
namespace {

/// The time in the clip, on a grid of a nanosecond: sums of frame times that differ in their last bits, because playing
/// began at another frame, show the same pose bit for bit.
double moment(const ClipSource& source) {
    constexpr double grid = 1 << 30;
    return std::round(animation::clip_time(source.playback, source.time) * grid) / grid;
}

} // namespace

void ClipMix::run(const ModelClips& clips) {
    poses_.resize(std::max(poses_.size(), sources.size()));
    if (caches_.size() < sources.size() + layers.size()) caches_.resize(sources.size() + layers.size());
    pointers.clear();
    for (std::size_t i = 0; i < sources.size(); ++i) {
        poses_[i] = clips.rest;
        sample(clips, sources[i], caches_[i], poses_[i], i == 0);
    }
    motion = {};
    if (root_motion) take_motion_out(clips);
    if (sources.size() == 1) {
        pose = poses_[0];
    } else {
        pose = clips.rest;
        std::vector<animation::BlendLayer> blended;
        for (std::size_t i = 0; i < sources.size(); ++i)
            blended.push_back({.pose = std::as_const(poses_[i]).span(), .weight = sources[i].weight});
        animation::BlendPosesJob{
            .layers = blended, .rest = clips.rest.span(), .out = pose.span(), .layout = &clips.set.layout}
            .run();
    }
    lay_over(clips);
}

void ClipMix::sample(const ModelClips& clips, const ClipSource& source, animation::SampleCache& cache,
                     animation::Pose& into, bool with_pointers) {
    if (source.clip < 0) return;
    const animation::Clip& clip = clips.set.clips[static_cast<std::size_t>(source.clip)];
    if (with_pointers) pointers.resize(clip.pointer_floats());
    animation::SampleClipJob job{.clip = &clip, .time = moment(source), .cache = &cache, .pose = into.span()};
    if (with_pointers) job.pointer_values = pointers;
    job.run();
}

void ClipMix::take_motion_out(const ModelClips& clips) {
    const animation::JointPose& rest = clips.rest.joints[root_motion->node];
    double total = 0.0;
    glm::dvec3 translation(0.0);
    glm::dquat rotation(0.0, 0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const ClipSource& source = sources[i];
        if (source.clip < 0) continue;
        const animation::Clip& clip = clips.set.clips[static_cast<std::size_t>(source.clip)];
        const animation::RigidMotion step = animation::root_motion_between(clip, *root_motion, rest, source.playback,
                                                                           std::max(0.0, source.previous), source.time);
        animation::JointPose& joint = poses_[i].joints[root_motion->node];
        joint = animation::without_root_motion(
            joint, animation::root_motion_in_clip(clip, *root_motion, rest, moment(source)));
        total += source.weight;
        translation += double{source.weight} * step.translation;
        const double sign = step.rotation.w < 0.0 ? -1.0 : 1.0; // steps are small: one hemisphere
        rotation = rotation + step.rotation * (sign * double{source.weight});
    }
    if (total <= 0.0) return;
    motion = {translation / total, glm::normalize(rotation)};
}

void ClipMix::lay_over(const ModelClips& clips) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const LayerSource& layer = layers[i];
        if (layer.source.clip < 0 || layer.source.weight <= 0.0f) continue;
        // What the clip does not move stays as it is.
        layer_pose_ = layer.additive ? clips.rest : pose;
        sample(clips, layer.source, caches_[sources.size() + i], layer_pose_, false);
        if (layer.additive) {
            reference_ = clips.rest;
            ClipSource start = layer.source;
            start.time = 0.0;
            start.playback = {.duration = layer.source.playback.duration, .mode = animation::LoopMode::once};
            sample(clips, start, reference_cache_, reference_, false);
            animation::AddPoseJob{.pose = pose.span(),
                                  .source = std::as_const(layer_pose_).span(),
                                  .reference = std::as_const(reference_).span(),
                                  .weight = layer.source.weight,
                                  .mask = layer.mask,
                                  .layout = &clips.set.layout}
                .run();
        } else {
            animation::OverlayPoseJob{.pose = pose.span(),
                                      .over = std::as_const(layer_pose_).span(),
                                      .weight = layer.source.weight,
                                      .mask = layer.mask,
                                      .layout = &clips.set.layout}
                .run();
        }
    }
}

} // namespace hachure
