#include <hachure/tests/runtime/animation/clip_builder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace hachure::animation {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

std::vector<float> times_of(const Clip& clip, std::size_t track = 0) {
    const std::span<const float> times = clip.times_of(clip.tracks.at(track));
    return {times.begin(), times.end()};
}

std::vector<float> values_of(const Clip& clip, std::size_t track = 0) {
    std::vector<float> all;
    for (std::size_t k = 0; k < times_of(clip, track).size(); ++k)
        for (const float v : clip.values_of(clip.tracks.at(track), k)) all.push_back(v);
    return all;
}

TEST(CompileClips, NothingGivesNothing) {
    ModelBuilder builder(0);
    EXPECT_THAT(builder.compile().clips, IsEmpty());
    EXPECT_THAT(builder.warnings, IsEmpty());
}

TEST(CompileClips, KeepsWhatIsWellFormed) {
    ModelBuilder builder(2, 2);
    builder.clip("walk");
    builder.channel(1, AnimationPath::scale, {0, 1}, {1, 1, 1, 2, 2, 2});
    builder.channel(0, AnimationPath::translation, {0, 1}, {1, 2, 3, 4, 5, 6}, Interpolation::step);
    builder.channel(0, AnimationPath::weights, {0, 2.5f}, {1, 2, 3, 4}, Interpolation::linear, 2);
    const ClipSet set = builder.compile();
    EXPECT_THAT(builder.warnings, IsEmpty());
    const Clip& clip = set.clips.at(0);
    EXPECT_EQ(clip.name, "walk");
    EXPECT_EQ(clip.duration, 2.5);
    ASSERT_EQ(clip.tracks.size(), 3u);
    EXPECT_EQ(clip.tracks[0].interpolation, Interpolation::step);
    EXPECT_THAT(values_of(clip, 0), ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(values_of(clip, 1), ElementsAre(1, 1, 1, 2, 2, 2));
    EXPECT_THAT(values_of(clip, 2), ElementsAre(1, 2, 3, 4));
    ASSERT_EQ(clip.targets.size(), 2u);
    EXPECT_EQ(clip.targets[0].parts, moves_translation | moves_weights);
    EXPECT_EQ(clip.targets[1].parts, moves_scale);
}

TEST(CompileClips, SharesKeyTimesThatAreEqual) {
    ModelBuilder builder(3);
    builder.clip("walk");
    for (int node = 0; node < 3; ++node) builder.channel(node, AnimationPath::scale, {0, 1}, {1, 1, 1, 2, 2, 2});
    builder.channel(0, AnimationPath::translation, {0, 3}, {1, 1, 1, 2, 2, 2});
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_EQ(clip.key_times.size(), 2u);
    EXPECT_EQ(clip.times.size(), 4u);
    EXPECT_EQ(clip.values.size(), 24u);
}

TEST(CompileClips, SortsKeysAndTakesTheLastOfOneTime) {
    ModelBuilder builder(1);
    builder.clip("walk");
    builder.channel(0, AnimationPath::scale, {2, 0, 1, 0, 1}, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5});
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_THAT(times_of(clip), ElementsAre(0, 1, 2));
    EXPECT_THAT(values_of(clip), ElementsAre(4, 4, 4, 5, 5, 5, 1, 1, 1));
    EXPECT_THAT(builder.warnings, Contains(AllOf(HasSubstr("sorted"), HasSubstr("'walk'"), HasSubstr("'a'"))));
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("the last is used: clip 'walk', node 'a'")));
}

TEST(CompileClips, SortsTheKeysOfSplinesWithTheirTangents) {
    ModelBuilder builder(1);
    builder.clip("walk");
    std::vector<float> values(18);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    builder.channel(0, AnimationPath::scale, {1, 0}, values, Interpolation::cubic_spline);
    EXPECT_THAT(values_of(builder.compile().clips.at(0)),
                ElementsAre(9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(CompileClips, KeepsKeysBeforeZero) {
    ModelBuilder builder(1);
    builder.clip("walk");
    builder.channel(0, AnimationPath::scale, {-1, 1}, {0, 0, 0, 2, 2, 2});
    const ClipSet set = builder.compile();
    EXPECT_EQ(set.clips.at(0).duration, 1.0);
    EXPECT_THAT(builder.warnings, ElementsAre(HasSubstr("before time 0")));
    EXPECT_EQ(sampled(set, builder.model, 0.0).joints[0].scale, glm::vec3(1.0f));
    builder.model.animations[0].channels[0].times = {-2, -1};
    EXPECT_EQ(builder.compile().clips.at(0).duration, 0.0);
}

TEST(CompileClips, LeavesOutKeysThatAreNotFinite) {
    ModelBuilder builder(1);
    builder.clip("walk");
    builder.channel(0, AnimationPath::scale, {nan, 1, 2, 3, infinity},
                    {1, 1, 1, 2, nan, 2, 3, 3, 3, 4, 4, infinity, 5, 5, 5});
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_THAT(times_of(clip), ElementsAre(2));
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("not finite")));
    EXPECT_EQ(clip.duration, 2.0);
}

TEST(CompileClips, NormalisesRotations) {
    ModelBuilder builder(1);
    builder.clip("turn");
    builder.channel(0, AnimationPath::rotation, {0, 1, 2}, {0, 0, 0, 0, 0, 3, 0, 4, 0.6f, 0, 0, 0.8f});
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_THAT(values_of(clip), ElementsAre(0, 0, 0, 1, 0, 0.6f, 0, 0.8f, 0.6f, 0, 0, 0.8f));
    EXPECT_THAT(builder.warnings, ElementsAre(HasSubstr("not unit are normalised: clip 'turn', node 'a'")));
}

TEST(CompileClips, NormalisesQuantisedRotationsInSilence) {
    ModelBuilder builder(1);
    builder.clip("turn");
    builder.channel(0, AnimationPath::rotation, {0}, {0, 0.71f, 0, 0.71f});
    EXPECT_THAT(values_of(builder.compile().clips.at(0)),
                ElementsAre(0, testing::FloatEq(std::sqrt(0.5f)), 0, testing::FloatEq(std::sqrt(0.5f))));
    EXPECT_EQ(builder.warnings.size(), 1u) << "only that the clip lasts no time";
}

TEST(CompileClips, ScalesTangentsWithTheirRotation) {
    ModelBuilder builder(1);
    builder.clip("turn");
    builder.channel(0, AnimationPath::rotation, {0}, {2, 0, 0, 0, 0, 0, 0, 2, 0, 4, 0, 0}, Interpolation::cubic_spline);
    EXPECT_THAT(values_of(builder.compile().clips.at(0)), ElementsAre(1, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 0));
}

TEST(CompileClips, UsesTheKeysThatAreComplete) {
    ModelBuilder builder(2);
    builder.clip("walk");
    builder.channel(0, AnimationPath::scale, {0, 1, 2}, {1, 1, 1, 2, 2, 2, 3});
    builder.channel(1, AnimationPath::scale, {0}, {1, 1, 1, 2, 2, 2});
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_THAT(times_of(clip, 0), ElementsAre(0, 1));
    EXPECT_THAT(times_of(clip, 1), ElementsAre(0));
    EXPECT_THAT(builder.warnings, ElementsAre(AllOf(HasSubstr("wrong number of values"), HasSubstr("node 'b'"))));
}

TEST(CompileClips, LeavesOutWhatHasNoKeysOrNoFittingTarget) {
    ModelBuilder builder(1);
    builder.clip("walk");
    builder.channel(0, AnimationPath::scale, {}, {});
    builder.channel(0, AnimationPath::scale, {0}, {});
    builder.channel(7, AnimationPath::scale, {0}, {1, 1, 1});
    builder.channel(-1, AnimationPath::scale, {0}, {1, 1, 1});
    builder.channel(0, AnimationPath::translation, {0}, {1, 1, 1, 1}, Interpolation::linear, 4);
    builder.channel(0, AnimationPath::weights, {0}, {1}, Interpolation::linear, 1);
    builder.channel(0, AnimationPath::scale, {0}, {1, 1, 1}).components = -3;
    builder.channel(-1, AnimationPath::pointer, {0}, {1, 1, 1});
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_THAT(clip.tracks, IsEmpty());
    EXPECT_THAT(clip.targets, IsEmpty());
    EXPECT_EQ(clip.duration, 0.0);
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("without keys")));
    EXPECT_THAT(builder.warnings, Contains(AllOf(HasSubstr("without a target"), HasSubstr("node 7"))));
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("do not fit their target")));
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("move nothing: 'walk'")));
}

TEST(CompileClips, TakesTheLastChannelOfATarget) {
    ModelBuilder builder(1);
    builder.clip("walk");
    builder.channel(0, AnimationPath::scale, {0, 1}, {1, 1, 1, 1, 1, 1});
    builder.channel(0, AnimationPath::translation, {0, 1}, {3, 3, 3, 3, 3, 3});
    builder.channel(0, AnimationPath::scale, {0, 1}, {2, 2, 2, 2, 2, 2}, Interpolation::step);
    const Clip clip = builder.compile().clips.at(0);
    ASSERT_EQ(clip.tracks.size(), 2u);
    EXPECT_EQ(values_of(clip, 1)[0], 2.0f);
    EXPECT_THAT(builder.warnings, ElementsAre(AllOf(HasSubstr("one target"), HasSubstr("'walk'"), HasSubstr("'a'"))));
}

TEST(CompileClips, ASinglePoseIsAClipWithoutLength) {
    ModelBuilder builder(1);
    builder.clip("pose");
    builder.channel(0, AnimationPath::scale, {0}, {2, 2, 2});
    const ClipSet set = builder.compile();
    EXPECT_EQ(set.clips.at(0).duration, 0.0);
    EXPECT_THAT(builder.warnings, ElementsAre(HasSubstr("single pose: 'pose'")));
    for (const double time : {-1.0, 0.0, 5.0})
        EXPECT_EQ(sampled(set, builder.model, time).joints[0].scale, glm::vec3(2.0f));
}

TEST(CompileClips, GivesEveryClipANameOfItsOwn) {
    ModelBuilder builder(1);
    for (const char* name : {"walk", "", "walk", "clip 3", "walk 2", "walk", ""}) builder.clip(name);
    const ClipSet set = builder.compile();
    std::vector<std::string> names;
    for (const Clip& clip : set.clips) names.push_back(clip.name);
    EXPECT_THAT(names, ElementsAre("walk", "clip 1", "walk 2", "clip 3", "walk 2 2", "walk 3", "clip 6"));
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("without a name get one: 'clip 1', 'clip 6'")));
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("taken are renamed: 'walk 2', 'walk 2 2', 'walk 3'")));
    EXPECT_EQ(find_clip(set, "walk 3"), 5u);
    EXPECT_EQ(find_clip(set, "run"), std::nullopt);
}

TEST(CompileClips, KeepsPointersApart) {
    ModelBuilder builder(1);
    builder.clip("glow");
    builder.channel(-1, AnimationPath::pointer, {0, 1}, {1, 2}, Interpolation::linear, 1).pointer = "/materials/0/x";
    builder.channel(-1, AnimationPath::pointer, {0, 1}, {1, 2, 3, 4}, Interpolation::linear, 2).pointer =
        "/cameras/0/y";
    const Clip clip = builder.compile().clips.at(0);
    EXPECT_THAT(builder.warnings, IsEmpty());
    EXPECT_THAT(clip.targets, IsEmpty());
    ASSERT_EQ(clip.pointers.size(), 2u);
    EXPECT_EQ(clip.pointer_floats(), 3u);
    for (const Track& track : clip.tracks) {
        const auto at = std::ranges::find(clip.pointers, track.output, &PointerChannel::first);
        ASSERT_NE(at, clip.pointers.end());
        EXPECT_EQ(at->components, at->pointer == "/materials/0/x" ? 1u : 2u);
        EXPECT_EQ(track.components, at->components);
    }
}

TEST(CompileClips, ResolvesPointersToNodes) {
    ModelBuilder builder(2, 2);
    builder.clip("walk");
    builder.channel(-1, AnimationPath::pointer, {0}, {0, 0, 0, 1}, Interpolation::linear, 4).pointer =
        "/nodes/1/rotation";
    builder.channel(-1, AnimationPath::pointer, {0}, {5, 6}, Interpolation::linear, 2).pointer = "/nodes/0/weights";
    builder.channel(-1, AnimationPath::pointer, {0}, {7}, Interpolation::linear, 1).pointer = "/nodes/0/weights/1";
    builder.channel(-1, AnimationPath::pointer, {0}, {7, 7, 7}).pointer = "/nodes/9/scale";
    builder.channel(-1, AnimationPath::pointer, {0}, {7, 7, 7}).pointer = "/nodes/x/scale";
    const Clip clip = builder.compile().clips.at(0);
    ASSERT_EQ(clip.targets.size(), 2u);
    EXPECT_EQ(clip.targets[0].parts, moves_weights);
    EXPECT_EQ(clip.targets[1].parts, moves_rotation);
    ASSERT_EQ(clip.pointers.size(), 2u) << "what is not a part of a node stays a pointer";
    EXPECT_THAT(builder.warnings, Contains(HasSubstr("without a target")));
}

TEST(CompileClips, MorphWeightsGoToTheirNode) {
    ModelBuilder builder(3, 2);
    builder.clip("smile");
    builder.channel(2, AnimationPath::weights, {0}, {0.25f, 0.5f}, Interpolation::linear, 2);
    const ClipSet set = builder.compile();
    EXPECT_EQ(set.clips.at(0).tracks.at(0).output, 4u);
    EXPECT_THAT(sampled(set, builder.model, 0.0).weights, ElementsAre(0, 0, 0, 0, 0.25f, 0.5f));
}

TEST(Pose, RestPoseIsTheFiles) {
    ModelBuilder builder(2, 2);
    builder.model.nodes[0].translation = {1, 2, 3};
    builder.model.nodes[1].translation = {9, 9, 9};
    builder.model.nodes[1].matrix = glm::mat4(1.0f);
    builder.model.nodes[1].morph_weights = {0.25f, 0.5f};
    builder.model.meshes[0].morph_weights = {0.75f, 1.0f};
    const PoseLayout layout = pose_layout(builder.model);
    const Pose pose = rest_pose(builder.model, layout);
    EXPECT_EQ(pose.joints[0].translation, glm::vec3(1, 2, 3));
    EXPECT_EQ(pose.joints[1], JointPose{});
    EXPECT_THAT(pose.weights, ElementsAre(0.75f, 1.0f, 0.25f, 0.5f));
    EXPECT_EQ(find_node(layout, "b"), 1u);
    EXPECT_EQ(find_node(layout, "z"), std::nullopt);
    Pose copy{std::vector<JointPose>(2), std::vector<float>(4)};
    copy_pose(pose.span(), copy.span());
    EXPECT_EQ(copy, pose);
}

} // namespace
} // namespace hachure::animation
