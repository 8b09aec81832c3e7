#include <hachure/runtime/animation/root_motion.h>
#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/runtime/assert.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure::animation {
namespace {

glm::dquat unit(const glm::dquat& q) {
    const double length = std::sqrt(glm::dot(q, q));
    return length > 0.0 ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

/// The part of a rotation that turns about an axis; none for a half turn across it, where every such part would do.
glm::dquat twist(const glm::dquat& q, const glm::dvec3& axis) {
    const double along = glm::dot(glm::dvec3(q.x, q.y, q.z), axis);
    if (q.w * q.w + along * along < 1e-24) return {1.0, 0.0, 0.0, 0.0};
    return unit(glm::dquat(q.w, axis * along));
}

glm::dvec3 moving_part(const glm::dvec3& translation, const RootMotionOptions& options) {
    const glm::dvec3 up(options.up);
    const glm::dvec3 along = up * glm::dot(translation, up);
    return (options.horizontal ? translation - along : glm::dvec3(0.0)) + (options.vertical ? along : glm::dvec3(0.0));
}

glm::dquat moving_part(const glm::dquat& rotation, const RootMotionOptions& options) {
    switch (options.rotation) {
    case RootRotation::yaw:
        return twist(rotation, glm::dvec3(options.up));
    case RootRotation::full:
        return unit(rotation);
    case RootRotation::none:
        break;
    }
    return {1.0, 0.0, 0.0, 0.0};
}

/// From the clip's start, carried on over its cycles.
RigidMotion unwrapped_motion(const Clip& clip, const RootMotionOptions& options, const JointPose& rest,
                             const Playback& playback, double time) {
    const PlaybackPlace place = playback_place(playback, time);
    const double clip_time = place.forward ? place.local : playback.duration - place.local;
    const RigidMotion within = root_motion_in_clip(clip, options, rest, clip_time);
    if (playback.mode != LoopMode::loop || place.cycle == 0.0) return within;
    const RigidMotion cycle = root_motion_in_clip(clip, options, rest, playback.duration);
    return repeated(cycle, place.forward ? place.cycle : -place.cycle) * within;
}

} // namespace

RigidMotion operator*(const RigidMotion& first, const RigidMotion& second) {
    return {first.translation + first.rotation * second.translation, unit(first.rotation * second.rotation)};
}

RigidMotion inverse(const RigidMotion& motion) {
    const glm::dquat back = glm::conjugate(motion.rotation);
    return {back * -motion.translation, back};
}

RigidMotion repeated(const RigidMotion& motion, double count) {
    RigidMotion power = count < 0.0 ? inverse(motion) : motion, result;
    double left = std::abs(count);
    while (left >= 1.0) {
        if (std::fmod(left, 2.0) >= 1.0) result = result * power;
        power = power * power;
        left = std::floor(left / 2.0);
    }
    return result;
}

RigidMotion in_outer_space(const RigidMotion& motion, const JointPose& inner) {
    const glm::dvec3 place(inner.translation);
    const glm::dquat turn = unit(glm::dquat(inner.rotation));
    const double scale = (static_cast<double>(inner.scale.x) + inner.scale.y + inner.scale.z) / 3.0;
    const glm::dquat rotation = unit(turn * motion.rotation * glm::conjugate(turn));
    return {place + turn * motion.translation * scale - rotation * place, rotation};
}

RigidMotion root_motion_in_clip(const Clip& clip, const RootMotionOptions& options, const JointPose& rest,
                                double clip_time) {
    HACHURE_ASSERT(std::abs(glm::length(options.up) - 1.0f) < 1e-3f, "up is a unit vector");
    JointPose start = rest, now = rest;
    sample_node(clip, options.node, 0.0, start);
    sample_node(clip, options.node, clip_time, now);
    if (now == start) return {};
    const glm::dquat turn = glm::dquat(now.rotation) * glm::conjugate(glm::dquat(start.rotation));
    const glm::dquat rotation = moving_part(turn, options);
    const glm::dvec3 from = moving_part(glm::dvec3(start.translation), options);
    return {moving_part(glm::dvec3(now.translation), options) - rotation * from, rotation};
}

RigidMotion root_motion_since_start(const Clip& clip, const RootMotionOptions& options, const JointPose& rest,
                                    const Playback& playback, double time) {
    return root_motion_between(clip, options, rest, playback, 0.0, time);
}

RigidMotion root_motion_between(const Clip& clip, const RootMotionOptions& options, const JointPose& rest,
                                const Playback& playback, double from, double to) {
    return inverse(unwrapped_motion(clip, options, rest, playback, from)) *
           unwrapped_motion(clip, options, rest, playback, to);
}

JointPose without_root_motion(const JointPose& pose, const RigidMotion& motion) {
    if (motion == RigidMotion{}) return pose;
    const glm::dquat back = glm::conjugate(motion.rotation);
    JointPose result = pose;
    result.translation = glm::vec3(back * (glm::dvec3(pose.translation) - motion.translation));
    result.rotation = glm::quat(unit(back * glm::dquat(pose.rotation)));
    return result;
}

} // namespace hachure::animation
