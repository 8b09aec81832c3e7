#pragma once

#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/animation/playback.h>
#include <hachure/runtime/animation/pose.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure::animation {

/// A rigid motion: turn, then move. In double precision, because long walks are sums of many.
struct RigidMotion {
    glm::dvec3 translation{0.0};             ///< metres
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< unit

    friend bool operator==(const RigidMotion&, const RigidMotion&) = default;
};

/// First `second`, then `first`, as matrices multiply: `first * second`.
[[nodiscard]] RigidMotion operator*(const RigidMotion& first, const RigidMotion& second);
[[nodiscard]] RigidMotion inverse(const RigidMotion& motion);
/// The motion done `count` times over; the inverse when negative. `count` is a whole number.
[[nodiscard]] RigidMotion repeated(const RigidMotion& motion, double count);
/// A motion of the inner space as the outer one sees it, where `inner` is the place of the inner space in the outer
/// (of a root joint's parent in the entity that is to move). The mean of its scales is used.
[[nodiscard]] RigidMotion in_outer_space(const RigidMotion& motion, const JointPose& inner);

/// Which part of the root's rotation is motion.
enum class RootRotation : std::uint8_t {
    none,
    yaw, ///< about the up axis
    full,
};

/// What of a root joint's animation moves the character instead of the joint.
struct RootMotionOptions {
    std::uint32_t node = 0;         ///< the root joint
    glm::vec3 up{0.0f, 1.0f, 0.0f}; ///< unit, in the frame of the joint's parent (0, 0, 1 for files made with Z up)
    bool horizontal = true;         ///< translation across the up axis
    bool vertical = false;          ///< translation along it: jumps
    RootRotation rotation = RootRotation::yaw;
};

/// The motion of the root joint from the clip's start to a moment in it, in the frame of the joint's parent: the
/// identity at time 0. The pose at that moment is this motion times the pose without it. `rest` is the joint's pose
/// where the clip does not move it.
[[nodiscard]] RigidMotion root_motion_in_clip(const Clip& clip, const RootMotionOptions& options, const JointPose& rest,
                                              double clip_time);

/// The motion since playing began, at a playing time: wraps of `loop` carry on from where the last cycle ended,
/// `ping_pong` goes back. A function of the time alone, so that a character is at the same place whichever frames were
/// shown. Playback::duration is the clip's.
[[nodiscard]] RigidMotion root_motion_since_start(const Clip& clip, const RootMotionOptions& options,
                                                  const JointPose& rest, const Playback& playback, double time);

/// The motion between two playing times, seen from where the character is at the first: multiply the character's place
/// by it from the right. A negative `from` counts as 0; `to` may be before `from`.
[[nodiscard]] RigidMotion root_motion_between(const Clip& clip, const RootMotionOptions& options, const JointPose& rest,
                                              const Playback& playback, double from, double to);

/// Takes the motion out of the root joint's pose: `pose` is the joint's at `clip_time`; the result stays over the place
/// that the joint has at the clip's start.
[[nodiscard]] JointPose without_root_motion(const JointPose& pose, const RigidMotion& motion);

} // namespace hachure::animation
