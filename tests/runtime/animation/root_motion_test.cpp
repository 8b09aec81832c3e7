#include <hachure/runtime/animation/root_motion.h>
#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/tests/runtime/animation/clip_builder.h>

#include <gtest/gtest.h>

#include <numbers>

namespace hachure::animation {
namespace {

constexpr double pi = std::numbers::pi;

/// A root that walks 2 m along x and bobs up by 0.5 m, in a clip of 1 s; it begins at (3, 1, 0).
ClipSet walking() {
    ModelBuilder builder(2);
    builder.clip("walk");
    builder.channel(0, AnimationPath::translation, {0, 0.5f, 1}, {3, 1, 0, 4, 1.5f, 0, 5, 1, 0});
    return builder.compile();
}

/// A root that walks a quarter circle to the left around (-1, 0, 0), turning with it; it begins at the origin, looking
/// along -z.
ClipSet turning() {
    ModelBuilder builder(1);
    builder.clip("turn");
    std::vector<float> times, places, rotations;
    for (int k = 0; k <= 64; ++k) {
        const float t = static_cast<float>(k) / 64.0f, angle = t * static_cast<float>(pi) / 2;
        times.push_back(t);
        places.insert(places.end(), {std::cos(angle) - 1, 0, -std::sin(angle)});
        const glm::quat q = about_y(angle);
        rotations.insert(rotations.end(), {q.x, q.y, q.z, q.w});
    }
    builder.channel(0, AnimationPath::translation, times, places);
    builder.channel(0, AnimationPath::rotation, times, rotations);
    return builder.compile();
}

void expect_motion(const RigidMotion& got, glm::dvec3 translation, double yaw, double tolerance = 1e-6) {
    EXPECT_LE(glm::length(got.translation - translation), tolerance)
        << got.translation.x << " " << got.translation.y << " " << got.translation.z;
    EXPECT_LE(angle_between(glm::quat(got.rotation), about_y(static_cast<float>(yaw))), std::max(tolerance, 1e-6));
}

JointPose root_at(const Clip& clip, double time) {
    JointPose pose;
    sample_node(clip, 0, time, pose);
    return pose;
}

TEST(RigidMotion, ComposesInvertsAndRepeats) {
    const RigidMotion step{{1, 0, 0}, glm::dquat(about_y(static_cast<float>(pi / 2)))};
    expect_motion(step * inverse(step), {0, 0, 0}, 0.0);
    expect_motion(repeated(step, 2.0), {1, 0, -1}, pi);
    expect_motion(repeated(step, 4.0), {0, 0, 0}, 0.0);
    expect_motion(repeated(step, -3.0) * repeated(step, 3.0), {0, 0, 0}, 0.0);
    expect_motion(repeated(step, 1e6 + 1), {1, 0, 0}, pi / 2, 0.2);
    EXPECT_EQ(repeated(step, 0.0), RigidMotion{});
    EXPECT_EQ(repeated({{1, 0, 0}, {1, 0, 0, 0}}, 1e9).translation, glm::dvec3(1e9, 0, 0));
}

TEST(RigidMotion, IsSeenFromOutside) {
    // A joint's space that lies on its side, in centimetres: its z is up, its y is -z outside.
    const JointPose armature{
        {5, 0, 0}, glm::angleAxis(static_cast<float>(-pi / 2), glm::vec3(1, 0, 0)), glm::vec3(0.01f)};
    const RigidMotion inner{{100, 200, 300}, glm::angleAxis(pi / 2, glm::dvec3(0, 0, 1))};
    const RigidMotion outer = in_outer_space(inner, armature);
    // A point of the inner space, moved inside and then seen, is the point as seen, moved outside.
    const glm::dvec3 point(10, 20, 30);
    const auto seen = [&](glm::dvec3 p) {
        return glm::dvec3(armature.translation) + glm::dquat(armature.rotation) * (p * 0.01);
    };
    const glm::dvec3 moved = seen(inner.translation + inner.rotation * point);
    EXPECT_LE(glm::length(outer.translation + outer.rotation * seen(point) - moved), 1e-6);
}

TEST(RootMotion, IsTheWayAcrossTheGround) {
    const ClipSet set = walking();
    const RootMotionOptions options;
    expect_motion(root_motion_in_clip(set.clips[0], options, {}, 0.0), {0, 0, 0}, 0.0);
    expect_motion(root_motion_in_clip(set.clips[0], options, {}, 0.5), {1, 0, 0}, 0.0);
    expect_motion(root_motion_in_clip(set.clips[0], {.vertical = true}, {}, 0.5), {1, 0.5, 0}, 0.0);
    expect_motion(root_motion_in_clip(set.clips[0], {.horizontal = false, .vertical = true}, {}, 0.5), {0, 0.5, 0},
                  0.0);
    expect_motion(root_motion_in_clip(set.clips[0], {.up = {1, 0, 0}}, {}, 0.5), {0, 0.5, 0}, 0.0);
    EXPECT_EQ(root_motion_in_clip(set.clips[0], {.node = 1}, {}, 0.5), RigidMotion{}) << "which the clip does not move";
}

TEST(RootMotion, CarriesOnOverWraps) {
    const ClipSet set = walking();
    const RootMotionOptions options;
    const Playback loop{1.0, 1.0, LoopMode::loop};
    expect_motion(root_motion_since_start(set.clips[0], options, {}, loop, 3.25), {6.5, 0, 0}, 0.0);
    expect_motion(root_motion_since_start(set.clips[0], options, {}, loop, 3.0), {6, 0, 0}, 0.0);
    expect_motion(root_motion_between(set.clips[0], options, {}, loop, 0.75, 1.25), {1, 0, 0}, 0.0);
    expect_motion(root_motion_between(set.clips[0], options, {}, loop, 1.25, 0.75), {-1, 0, 0}, 0.0);
    const Playback later{1.0, 2.0, LoopMode::loop, 0.5};
    expect_motion(root_motion_since_start(set.clips[0], options, {}, later, 1.0), {4, 0, 0}, 0.0);
    const Playback back{1.0, -1.0, LoopMode::loop};
    expect_motion(root_motion_since_start(set.clips[0], options, {}, back, 2.25), {-4.5, 0, 0}, 0.0);
    const Playback there_and_back{1.0, 1.0, LoopMode::ping_pong};
    expect_motion(root_motion_since_start(set.clips[0], options, {}, there_and_back, 1.25), {1.5, 0, 0}, 0.0);
    expect_motion(root_motion_since_start(set.clips[0], options, {}, there_and_back, 8.0), {0, 0, 0}, 0.0);
    const Playback once{1.0, 1.0, LoopMode::once};
    expect_motion(root_motion_since_start(set.clips[0], options, {}, once, 99.0), {2, 0, 0}, 0.0);
}

TEST(RootMotion, FourQuartersAreACircle) {
    const ClipSet set = turning();
    const RootMotionOptions options;
    const Playback loop{1.0, 1.0, LoopMode::loop};
    expect_motion(root_motion_since_start(set.clips[0], options, {}, loop, 1.0), {-1, 0, -1}, pi / 2);
    expect_motion(root_motion_since_start(set.clips[0], options, {}, loop, 2.0), {-2, 0, 0}, pi);
    expect_motion(root_motion_since_start(set.clips[0], options, {}, loop, 4.0), {0, 0, 0}, 0.0);
    expect_motion(root_motion_since_start(set.clips[0], options, {}, loop, 4001.0), {-1, 0, -1}, pi / 2, 1e-3);
    // Straight on means along the circle, wherever it is.
    const RigidMotion here = root_motion_between(set.clips[0], options, {}, loop, 0.25, 0.5);
    const RigidMotion there = root_motion_between(set.clips[0], options, {}, loop, 2.75, 3.0);
    EXPECT_LE(glm::length(here.translation - there.translation), 1e-5);
}

TEST(RootMotion, StepsAddUpWhateverTheirLength) {
    const ClipSet set = turning();
    for (const LoopMode mode : {LoopMode::once, LoopMode::loop, LoopMode::ping_pong})
        for (const double speed : {0.7, -1.3}) {
            const Playback playback{1.0, speed, mode, 0.3};
            RigidMotion sum;
            double at = 0.0;
            for (int i = 1; i <= 40; ++i) {
                const double to = at + 0.01 * (1 + i * 7 % 30);
                sum = sum * root_motion_between(set.clips[0], {}, {}, playback, at, to);
                at = to;
            }
            const RigidMotion whole = root_motion_since_start(set.clips[0], {}, {}, playback, at);
            EXPECT_LE(glm::length(sum.translation - whole.translation), 1e-6);
            EXPECT_LE(angle_between(glm::quat(sum.rotation), glm::quat(whole.rotation)), 1e-6);
        }
}

TEST(RootMotion, MotionTimesWhatIsLeftIsThePose) {
    for (const ClipSet& set : {walking(), turning()})
        for (const RootRotation rotation : {RootRotation::none, RootRotation::yaw, RootRotation::full})
            for (const bool vertical : {false, true})
                for (const double time : {0.0, 0.3, 0.77, 1.0}) {
                    const RootMotionOptions options{.vertical = vertical, .rotation = rotation};
                    const RigidMotion motion = root_motion_in_clip(set.clips[0], options, {}, time);
                    const JointPose pose = root_at(set.clips[0], time), left = without_root_motion(pose, motion);
                    const glm::dvec3 again = motion.translation + motion.rotation * glm::dvec3(left.translation);
                    EXPECT_LE(glm::length(again - glm::dvec3(pose.translation)), 1e-6);
                    EXPECT_LE(angle_between(glm::quat(motion.rotation) * left.rotation, pose.rotation), 1e-6);
                    EXPECT_TRUE(time > 0.0 || left == pose);
                }
}

TEST(RootMotion, WhatIsLeftStaysOverItsStart) {
    const ClipSet set = turning();
    const JointPose start = root_at(set.clips[0], 0.0);
    for (const double time : {0.2, 0.5, 1.0}) {
        const RigidMotion motion = root_motion_in_clip(set.clips[0], {}, {}, time);
        const JointPose left = without_root_motion(root_at(set.clips[0], time), motion);
        EXPECT_LE(glm::length(left.translation - start.translation), 1e-6f);
        EXPECT_LE(angle_between(left.rotation, start.rotation), 1e-6);
    }
}

TEST(RootMotion, YawLeavesTheLeanInThePose) {
    ModelBuilder builder(1);
    builder.clip("lean");
    const glm::quat lean = about_y(1.0f) * glm::angleAxis(0.4f, glm::vec3(1, 0, 0));
    builder.channel(0, AnimationPath::rotation, {0, 1}, {0, 0, 0, 1, lean.x, lean.y, lean.z, lean.w});
    const ClipSet set = builder.compile();
    const RigidMotion motion = root_motion_in_clip(set.clips[0], {}, {}, 1.0);
    expect_motion(motion, {0, 0, 0}, 1.0);
    const JointPose left = without_root_motion(root_at(set.clips[0], 1.0), motion);
    EXPECT_LE(angle_between(left.rotation, glm::angleAxis(0.4f, glm::vec3(1, 0, 0))), 1e-6);
}

TEST(RootMotion, AHalfTurnAcrossUpHasNoYaw) {
    ModelBuilder builder(1);
    builder.clip("flip");
    builder.channel(0, AnimationPath::rotation, {0, 1}, {0, 0, 0, 1, 1, 0, 0, 0});
    const RigidMotion motion = root_motion_in_clip(builder.compile().clips[0], {}, {}, 1.0);
    expect_motion(motion, {0, 0, 0}, 0.0);
}

} // namespace
} // namespace hachure::animation
