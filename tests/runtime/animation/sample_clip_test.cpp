#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/tests/runtime/animation/clip_builder.h>
#include <hachure/tests/runtime/animation/gltf_sampling.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hachure::animation {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr float huge = std::numeric_limits<float>::max();

glm::vec3 scale_at(ModelBuilder& builder, double time) {
    return sampled(builder.compile(), builder.model, time).joints[0].scale;
}

TEST(SampleClip, StepsHoldTheirValue) {
    ModelBuilder builder(1);
    builder.clip("c");
    builder.channel(0, AnimationPath::scale, {1, 2}, {1, 2, 3, 4, 5, 6}, Interpolation::step);
    for (const double time : {-5.0, 1.0, 1.5, std::nextafter(2.0, 0.0)})
        EXPECT_EQ(scale_at(builder, time), glm::vec3(1, 2, 3)) << time;
    for (const double time : {2.0, 9.0}) EXPECT_EQ(scale_at(builder, time), glm::vec3(4, 5, 6)) << time;
}

TEST(SampleClip, LinesGoThroughTheirKeysExactly) {
    ModelBuilder builder(1);
    builder.clip("c");
    builder.channel(0, AnimationPath::scale, {1, 2, 4}, {0.1f, 2, 3, 0.3f, 5, 6, 0.7f, 8, 9});
    EXPECT_EQ(scale_at(builder, 0.0), glm::vec3(0.1f, 2, 3));
    EXPECT_EQ(scale_at(builder, 1.0), glm::vec3(0.1f, 2, 3));
    EXPECT_EQ(scale_at(builder, 2.0), glm::vec3(0.3f, 5, 6));
    EXPECT_EQ(scale_at(builder, 4.0), glm::vec3(0.7f, 8, 9));
    EXPECT_EQ(scale_at(builder, 5.0), glm::vec3(0.7f, 8, 9));
    EXPECT_FLOAT_EQ(scale_at(builder, 2.5).y, 5.75f);
}

TEST(SampleClip, SplinesScaleTangentsByTheirLength) {
    ModelBuilder builder(1);
    builder.clip("c");
    // From 0 to 0 in 2 s with a slope of 1 at the start and -1 at the end: t (1 - t / 2).
    builder.channel(0, AnimationPath::scale, {0, 2}, {9, 9, 9, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 9, 9, 9},
                    Interpolation::cubic_spline);
    for (const double t : {0.25, 0.5, 1.0, 1.75}) EXPECT_NEAR(scale_at(builder, t).x, t * (1.0 - t / 2.0), 1e-6) << t;
    EXPECT_EQ(scale_at(builder, 0.0), glm::vec3(0.0f));
    EXPECT_EQ(scale_at(builder, 2.0), glm::vec3(0.0f));
}

TEST(SampleClip, RotationsTakeTheShortWayAtAnEvenSpeed) {
    ModelBuilder builder(1);
    const glm::quat end = about_y(2.0f);
    builder.clip("c");
    builder.channel(0, AnimationPath::rotation, {0, 1}, {0, 0, 0, 1, -end.x, -end.y, -end.z, -end.w});
    const ClipSet set = builder.compile();
    for (const double t : {0.0, 0.125, 0.5, 0.75, 1.0})
        EXPECT_NEAR(
            angle_between(sampled(set, builder.model, t).joints[0].rotation, about_y(2.0f * static_cast<float>(t))),
            0.0, 1e-6)
            << t;
}

TEST(SampleClip, RotationsNearAndFarAreAccurate) {
    for (const float angle : {1e-6f, 1e-4f, 1e-3f, 8.9e-3f, 9.0e-3f, 0.1f, 1.0f, 3.0f, 3.14f, 3.1415926f}) {
        ModelBuilder builder(1);
        const glm::quat end = about_y(angle);
        builder.clip("c");
        builder.channel(0, AnimationPath::rotation, {0, 1}, {0, 0, 0, 1, end.x, end.y, end.z, end.w});
        const Pose pose = sampled(builder.compile(), builder.model, 0.3);
        const auto expected = gltf_sampling::sample(builder.model.animations[0].channels[0], 0.3);
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(pose.joints[0].rotation[i], expected[static_cast<std::size_t>(i)], 2e-7) << angle << " " << i;
    }
}

TEST(SampleClip, WritesOnlyWhatTheClipMoves) {
    ModelBuilder builder(3, 1);
    builder.clip("c");
    builder.channel(1, AnimationPath::translation, {0}, {1, 2, 3});
    builder.channel(2, AnimationPath::weights, {0}, {0.5f}, Interpolation::linear, 1);
    const ClipSet set = builder.compile();
    const JointPose other{{7, 7, 7}, {0, 1, 0, 0}, {8, 8, 8}};
    Pose pose{std::vector<JointPose>(3, other), std::vector<float>(3, 9.0f)};
    std::vector<std::uint8_t> written{0, moves_scale, 0};
    SampleCache cache;
    SampleClipJob job{&set.clips[0], 0.0, &cache, pose.span(), {}, written};
    job.validate();
    job.run();
    JointPose moved = other;
    moved.translation = {1, 2, 3};
    EXPECT_EQ(pose.joints, (std::vector<JointPose>{other, moved, other}));
    EXPECT_THAT(pose.weights, ElementsAre(9.0f, 9.0f, 0.5f));
    EXPECT_THAT(written, ElementsAre(0, moves_scale | moves_translation, moves_weights));
}

TEST(SampleClip, SamplesPointersWhenAsked) {
    ModelBuilder builder(1);
    builder.clip("c");
    builder.channel(-1, AnimationPath::pointer, {0, 1}, {0, 10}, Interpolation::linear, 1).pointer = "/a";
    builder.channel(-1, AnimationPath::pointer, {0, 1}, {1, 2, 3, 4}, Interpolation::step, 2).pointer = "/b";
    const ClipSet set = builder.compile();
    Pose pose = rest_pose(builder.model, set.layout);
    SampleCache cache;
    std::vector<float> values(set.clips[0].pointer_floats());
    SampleClipJob job{&set.clips[0], 0.5, &cache, pose.span(), values};
    job.validate();
    job.run();
    for (const PointerChannel& pointer : set.clips[0].pointers) {
        EXPECT_EQ(values.at(pointer.first), pointer.pointer == "/a" ? 5.0f : 1.0f);
        EXPECT_TRUE(pointer.pointer == "/a" || values.at(pointer.first + 1) == 2.0f);
    }
    job.pointer_values = {};
    job.validate();
    job.run();
}

/// A clip of random kinds, lengths and keys.
ModelBuilder random_model(std::mt19937& random) {
    ModelBuilder builder(4, 2);
    builder.clip("c");
    std::uniform_real_distribution<float> value(-2.0f, 2.0f), gap(1e-3f, 1.0f);
    for (int node = 0; node < 4; ++node)
        for (const AnimationPath path : {AnimationPath::translation, AnimationPath::rotation, AnimationPath::weights}) {
            const auto interpolation = static_cast<Interpolation>(random() % 3);
            std::vector<float> times(1 + random() % 40), values;
            float time = gap(random);
            for (float& t : times) t = time += gap(random);
            const std::size_t components = path == AnimationPath::rotation ? 4 : path == AnimationPath::weights ? 2 : 3;
            values.resize(times.size() * components * (interpolation == Interpolation::cubic_spline ? 3 : 1));
            for (float& v : values) v = value(random);
            builder.channel(node, path, times, values, interpolation, static_cast<std::int32_t>(components));
        }
    return builder;
}

TEST(SampleClip, NeverDependsOnTheCache) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> moment(-1.0, 25.0);
    SampleCache kept; // one for all clips
    for (int round = 0; round < 20; ++round) {
        ModelBuilder builder = random_model(random);
        const ClipSet set = builder.compile();
        Pose pose = rest_pose(builder.model, set.layout);
        for (int i = 0; i < 200; ++i) {
            const double time = i % 2 == 0 ? moment(random) : 0.1 * i;
            SampleClipJob job{&set.clips[0], time, &kept, pose.span()};
            job.validate();
            job.run();
            ASSERT_EQ(pose, sampled(set, builder.model, time)) << time;
            JointPose joint;
            sample_node(set.clips[0], 2, time, joint);
            ASSERT_EQ(joint, pose.joints[2]) << time;
        }
    }
}

TEST(SampleClip, AgreesWithTheSpecificationOnRandomClips) {
    std::mt19937 random(4);
    for (int round = 0; round < 30; ++round) {
        ModelBuilder builder = random_model(random);
        for (assets::AnimationChannel& channel : builder.model.animations[0].channels) {
            if (channel.path != AnimationPath::rotation || channel.interpolation != Interpolation::cubic_spline)
                continue;
            // Far from unit, splines of quaternions are not those of the file: each key is scaled.
            for (std::size_t k = 0; k < channel.times.size(); ++k) {
                gltf_sampling::Value q = gltf_sampling::part(channel, k, 1);
                gltf_sampling::normalise(q);
                for (std::size_t i = 0; i < 4; ++i) channel.values[12 * k + 4 + i] = static_cast<float>(q[i]);
            }
        }
        const ClipSet set = builder.compile();
        for (double time = -0.5; time < 22.0; time += 0.173) {
            const Pose pose = sampled(set, builder.model, time);
            for (const assets::AnimationChannel& channel : builder.model.animations[0].channels) {
                const gltf_sampling::Value expected = gltf_sampling::sample(channel, time);
                const auto node = static_cast<std::size_t>(channel.node);
                for (int i = 0; i < channel.components; ++i) {
                    const JointPose& joint = pose.joints[node];
                    const float got = channel.path == AnimationPath::rotation ? joint.rotation[i]
                                      : channel.path == AnimationPath::weights
                                          ? pose.weights[2 * node + static_cast<std::size_t>(i)]
                                          : joint.translation[i];
                    ASSERT_NEAR(got, expected[static_cast<std::size_t>(i)], 2e-5) << time;
                }
            }
        }
    }
}

TEST(SampleClip, HugeNumbersStayFinite) {
    ModelBuilder builder(2);
    builder.clip("c");
    builder.channel(0, AnimationPath::scale, {0, 1}, {huge, -huge, huge, -huge, huge, huge});
    builder.channel(0, AnimationPath::translation, {0, huge},
                    {huge, huge, huge, huge, -huge, 0, huge, -huge, huge, -huge, huge, -huge, huge, huge, 1, 1, 1, 1},
                    Interpolation::cubic_spline);
    builder.channel(0, AnimationPath::rotation, {0, 1},
                    {huge, huge,  huge, huge, 0, 0, 0, 1,  huge, -huge, huge, -huge, //
                     huge, -huge, huge, 0,    0, 0, 0, -1, huge, huge,  huge, huge},
                    Interpolation::cubic_spline);
    builder.channel(1, AnimationPath::rotation, {0, 1}, {huge, huge, huge, huge, 1e-38f, 0, 0, 1e-38f});
    const ClipSet set = builder.compile();
    for (const double time : {0.0, 1e-30, 0.25, 0.5, 0.999999999, 1.0, 1e20, 1e38, 1e300})
        for (const JointPose& joint : sampled(set, builder.model, time).joints)
            for (int i = 0; i < 4; ++i) {
                EXPECT_TRUE(std::isfinite(joint.rotation[i])) << time;
                EXPECT_TRUE(i == 3 || std::isfinite(joint.translation[i])) << time;
                EXPECT_TRUE(i == 3 || std::isfinite(joint.scale[i])) << time;
                EXPECT_NEAR(glm::length(joint.rotation), 1.0f, 1e-6f) << time;
            }
}

TEST(SampleClip, SplinesOfRotationsThatVanishKeepTheirKey) {
    ModelBuilder builder(1);
    builder.clip("c");
    builder.channel(0, AnimationPath::rotation, {0, 1},
                    {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0},
                    Interpolation::cubic_spline);
    const Pose pose = sampled(builder.compile(), builder.model, 0.5);
    EXPECT_EQ(pose.joints[0].rotation, glm::quat(1, 0, 0, 0));
}

/// Keys looked at per frame while a clip of so many keys plays at two frames per key.
double searching_cost(std::size_t keys, double speed) {
    ModelBuilder builder(1);
    builder.clip("c");
    std::vector<float> times(keys);
    for (std::size_t k = 0; k < keys; ++k) times[k] = static_cast<float>(k);
    builder.channel(0, AnimationPath::scale, times, std::vector<float>(3 * keys, 1.0f));
    const ClipSet set = builder.compile();
    Pose pose = rest_pose(builder.model, set.layout);
    SampleCache cache;
    SampleClipJob job{&set.clips[0], 0.0, &cache, pose.span()};
    std::uint64_t before = 0;
    const int frames = 500;
    for (int frame = 0; frame <= frames; ++frame) {
        const double from_start = frame * std::abs(speed);
        job.time = (speed < 0.0 ? static_cast<double>(keys - 1) : 0.0) + (speed < 0.0 ? -from_start : from_start);
        job.run();
        if (frame == 0) before = cache.keys_looked_at; // the first one is a jump
    }
    return static_cast<double>(cache.keys_looked_at - before) / frames;
}

TEST(SampleClip, CostDoesNotGrowWithTheLengthOfTheClip) {
    for (const double speed : {0.5, -0.5, 1.0, 3.0}) {
        const double length = searching_cost(2'000, speed), longer = searching_cost(200'000, speed);
        EXPECT_LE(longer, length + 0.01) << speed;
        EXPECT_LE(longer, 8.0) << speed;
    }
}

TEST(SampleClip, JumpsCostTheLogarithm) {
    ModelBuilder builder(1);
    const std::size_t keys = 1 << 20;
    std::vector<float> times(keys);
    for (std::size_t k = 0; k < keys; ++k) times[k] = static_cast<float>(k);
    builder.clip("c");
    builder.channel(0, AnimationPath::scale, times, std::vector<float>(3 * keys, 1.0f));
    const ClipSet set = builder.compile();
    Pose pose = rest_pose(builder.model, set.layout);
    SampleCache cache;
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const std::uint64_t before = cache.keys_looked_at;
        SampleClipJob job{&set.clips[0], static_cast<double>(random() % keys), &cache, pose.span()};
        job.run();
        EXPECT_LE(cache.keys_looked_at - before, 44u);
    }
}

} // namespace
} // namespace hachure::animation
