#include <hachure/runtime/animation/blend.h>
#include <hachure/tests/runtime/animation/clip_builder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hachure::animation {
namespace {

using testing::ElementsAre;

/// Three nodes in a chain with two morph weights each.
class BlendTest : public ::testing::Test {
protected:
    Pose random_pose() {
        std::uniform_real_distribution<float> value(-1.0f, 1.0f);
        Pose pose{std::vector<JointPose>(3), std::vector<float>(6)};
        for (JointPose& joint : pose.joints) {
            joint.translation = {value(random_), value(random_), value(random_)};
            joint.rotation =
                glm::normalize(glm::quat(value(random_), value(random_), value(random_), value(random_) + 0.01f));
            joint.scale = glm::vec3(2.0f + value(random_));
        }
        for (float& weight : pose.weights) weight = value(random_);
        return pose;
    }

    Pose blend(const std::vector<BlendLayer>& layers) {
        Pose out = random_pose();
        BlendPosesJob job{layers, rest_.span(), out.span(), &layout_};
        job.validate();
        job.run();
        return out;
    }

    Pose add(Pose pose, const Pose& source, const Pose& reference, float weight, std::span<const float> mask = {}) {
        AddPoseJob job{pose.span(), source.span(), reference.span(), weight, mask, &layout_};
        job.validate();
        job.run();
        return pose;
    }

    Pose overlay(Pose pose, const Pose& over, float weight, std::span<const float> mask = {}) {
        OverlayPoseJob job{pose.span(), over.span(), weight, mask, &layout_};
        job.validate();
        job.run();
        return pose;
    }

    std::mt19937 random_{5};
    const PoseLayout layout_ = pose_layout(ModelBuilder(3, 2).model);
    const Pose rest_ = random_pose();
};

void expect_near(const Pose& a, const Pose& b, double tolerance) {
    for (std::size_t n = 0; n < a.joints.size(); ++n) {
        EXPECT_LE(glm::length(a.joints[n].translation - b.joints[n].translation), tolerance) << n;
        EXPECT_LE(glm::length(a.joints[n].scale - b.joints[n].scale), tolerance) << n;
        EXPECT_LE(angle_between(a.joints[n].rotation, b.joints[n].rotation), tolerance) << n;
    }
    for (std::size_t i = 0; i < a.weights.size(); ++i) EXPECT_NEAR(a.weights[i], b.weights[i], tolerance);
}

TEST_F(BlendTest, OneLayerComesOutBitForBit) {
    const Pose a = random_pose(), b = random_pose();
    EXPECT_EQ(blend({{a.span(), 0.3f}}), a);
    EXPECT_EQ(blend({{b.span(), 0.0f}, {a.span(), 1.0f}, {b.span(), 0.0f}}), a);
    EXPECT_EQ(blend({{a.span(), 1.0f}, {b.span(), 0.0f}}), a);
}

TEST_F(BlendTest, WithoutAWeightTheRestPoseComesOut) {
    const Pose a = random_pose();
    EXPECT_EQ(blend({}), rest_);
    EXPECT_EQ(blend({{a.span(), 0.0f}}), rest_);
}

TEST_F(BlendTest, WeightsAreRelative) {
    const Pose a = random_pose(), b = random_pose(), c = random_pose();
    const Pose one = blend({{a.span(), 0.2f}, {b.span(), 0.3f}, {c.span(), 0.5f}});
    expect_near(blend({{a.span(), 200.0f}, {b.span(), 300.0f}, {c.span(), 500.0f}}), one, 1e-6);
    expect_near(blend({{a.span(), 2e37f}, {b.span(), 3e37f}, {c.span(), 5e37f}}), one, 1e-6);
    expect_near(blend({{c.span(), 5e-40f}, {a.span(), 2e-40f}, {b.span(), 3e-40f}}), one, 1e-4);
    for (std::size_t n = 0; n < 3; ++n) {
        const glm::vec3 mean =
            0.2f * a.joints[n].translation + 0.3f * b.joints[n].translation + 0.5f * c.joints[n].translation;
        EXPECT_LE(glm::length(one.joints[n].translation - mean), 1e-6f);
        EXPECT_NEAR(glm::length(one.joints[n].rotation), 1.0f, 1e-6f);
    }
}

TEST_F(BlendTest, RotationsTakeTheShortWay) {
    Pose a = random_pose(), b = a;
    a.joints[0].rotation = about_y(0.2f);
    b.joints[0].rotation = -about_y(0.8f);
    const Pose half = blend({{a.span(), 1.0f}, {b.span(), 1.0f}});
    EXPECT_NEAR(angle_between(half.joints[0].rotation, about_y(0.5f)), 0.0, 1e-6);
}

// What the header promises about blending with sums instead of slerp.
TEST_F(BlendTest, TheSpeedAlongTheArcIsOffByAsMuchAsPromised) {
    for (const auto& [degrees, most] : {std::pair{90.0f, 1.0}, {179.9f, 8.2}}) {
        Pose a = random_pose(), b = a;
        a.joints[0].rotation = about_y(0.0f);
        b.joints[0].rotation = about_y(glm::radians(degrees));
        double worst = 0.0;
        for (float w = 0.01f; w < 1.0f; w += 0.01f) {
            const glm::quat mixed = blend({{a.span(), 1.0f - w}, {b.span(), w}}).joints[0].rotation;
            worst = std::max(worst, angle_between(mixed, about_y(glm::radians(degrees * w))));
        }
        EXPECT_LE(glm::degrees(worst), most);
        EXPECT_GE(glm::degrees(worst), 0.8 * most);
    }
}

TEST_F(BlendTest, OppositeRotationsStayUnit) {
    Pose a = random_pose(), b = a, c = a;
    a.joints[0].rotation = {1, 0, 0, 0};
    b.joints[0].rotation = {0, 1, 0, 0};
    c.joints[0].rotation = {0, -1, 0, 0};
    for (const Pose& pose : {blend({{a.span(), 1e-30f}, {b.span(), 1.0f}, {c.span(), 1.0f}}),
                             blend({{b.span(), 1.0f}, {c.span(), 1.0f}}), overlay(b, c, 0.5f), overlay(a, c, 0.5f)})
        EXPECT_NEAR(glm::length(pose.joints[0].rotation), 1.0f, 1e-6f);
}

TEST_F(BlendTest, MasksDivideTheJoints) {
    const Pose a = random_pose(), b = random_pose();
    const std::vector<float> upper{0, 0, 1}, lower{1, 0, 0};
    const Pose out = blend({{a.span(), 1.0f, upper}, {b.span(), 1.0f, lower}});
    EXPECT_EQ(out.joints[0], b.joints[0]);
    EXPECT_EQ(out.joints[1], rest_.joints[1]);
    EXPECT_EQ(out.joints[2], a.joints[2]);
    EXPECT_THAT(out.weights, ElementsAre(b.weights[0], b.weights[1], rest_.weights[2], rest_.weights[3], a.weights[4],
                                         a.weights[5]));
}

TEST_F(BlendTest, WritesOverAnyOfItsLayers) {
    const Pose a = random_pose(), b = random_pose();
    const Pose expected = blend({{a.span(), 0.25f}, {b.span(), 0.75f}});
    for (int over = 0; over < 2; ++over) {
        Pose first = a, second = b;
        const std::vector<BlendLayer> layers{{first.span(), 0.25f}, {second.span(), 0.75f}};
        BlendPosesJob job{layers, rest_.span(), over == 0 ? first.span() : second.span(), &layout_};
        job.run();
        EXPECT_EQ(over == 0 ? first : second, expected);
    }
}

TEST_F(BlendTest, OverlayReplacesKeepsAndFades) {
    const Pose a = random_pose(), b = random_pose();
    EXPECT_EQ(overlay(a, b, 0.0f), a);
    EXPECT_EQ(overlay(a, b, 1.0f), b);
    expect_near(overlay(a, b, 0.25f), blend({{a.span(), 0.75f}, {b.span(), 0.25f}}), 1e-5);
    const std::vector<float> mask{0, 1, 0};
    Pose expected = a;
    expected.joints[1] = b.joints[1];
    expected.weights[2] = b.weights[2];
    expected.weights[3] = b.weights[3];
    EXPECT_EQ(overlay(a, b, 1.0f, mask), expected);
}

TEST_F(BlendTest, AddingTheReferenceChangesNothing) {
    const Pose a = random_pose(), reference = random_pose();
    EXPECT_EQ(add(a, reference, reference, 1.0f), a);
    EXPECT_EQ(add(a, reference, reference, 0.37f), a);
    EXPECT_EQ(add(a, random_pose(), reference, 0.0f), a);
    EXPECT_EQ(add(a, random_pose(), reference, 1.0f, std::vector<float>(3, 0.0f)), a);
}

TEST_F(BlendTest, AddingToTheReferenceGivesTheSource) {
    for (int i = 0; i < 20; ++i) {
        const Pose reference = random_pose(), source = random_pose();
        expect_near(add(reference, source, reference, 1.0f), source, 3e-6);
    }
}

TEST_F(BlendTest, AddsPartsOfADifference) {
    Pose base = rest_, source = rest_, reference = rest_;
    base.joints[0] = {{1, 0, 0}, about_y(0.3f), {2, 2, 2}};
    reference.joints[0] = {{0, 0, 0}, about_y(1.0f), {1, 2, 0}};
    source.joints[0] = {{0, 4, 0}, about_y(1.8f), {3, 1, 1}};
    base.weights[0] = 0.5f;
    reference.weights[0] = 0.25f;
    source.weights[0] = 0.75f;
    const JointPose sum = add(base, source, reference, 0.5f).joints[0];
    EXPECT_EQ(sum.translation, glm::vec3(1, 2, 0));
    EXPECT_NEAR(angle_between(sum.rotation, about_y(0.7f)), 0.0, 1e-6);
    EXPECT_EQ(sum.scale, glm::vec3(4, 1.5f, 2.5f)) << "the scale of 0 has no ratio: there the difference is added";
    EXPECT_EQ(add(base, source, reference, 0.5f).weights[0], 0.75f);
}

TEST_F(BlendTest, DifferencesAreThoseOfTheParent) {
    // The joint lies on its side; what turned the reference about the parent's y turns it about the parent's y.
    Pose base = rest_, source = rest_, reference = rest_;
    base.joints[0].rotation = glm::angleAxis(1.5f, glm::vec3(1, 0, 0));
    reference.joints[0].rotation = glm::angleAxis(0.4f, glm::vec3(0, 0, 1));
    source.joints[0].rotation = about_y(0.5f) * reference.joints[0].rotation;
    const glm::quat sum = add(base, source, reference, 1.0f).joints[0].rotation;
    EXPECT_NEAR(angle_between(sum, about_y(0.5f) * base.joints[0].rotation), 0.0, 1e-6);
}

TEST(Masks, HoldABranch) {
    ModelBuilder builder(5);
    // a - b - c and a - d, e alone; a child may stand before its parent.
    const std::vector<std::int32_t> parents{-1, 3, 1, 0, -1};
    for (std::size_t n = 0; n < 5; ++n) builder.model.nodes[n].parent = parents[n];
    const PoseLayout layout = pose_layout(builder.model);
    EXPECT_EQ(make_mask(layout, "b"), (std::vector<float>{0, 1, 1, 0, 0}));
    EXPECT_EQ(make_mask(layout, "d", 0.5f, 0.25f), (std::vector<float>{0.25f, 0.5f, 0.5f, 0.5f, 0.25f}));
    EXPECT_EQ(make_mask(layout, "a"), (std::vector<float>{1, 1, 1, 1, 0}));
    EXPECT_EQ(make_mask(layout, "nobody"), std::nullopt);
    std::vector<float> mask = *make_mask(layout, "a");
    mask_branch(layout, 2, 0.0f, mask);
    EXPECT_EQ(mask, (std::vector<float>{1, 1, 0, 1, 0}));
}

TEST(Masks, AreQuickOnChainsOfAnyLength) {
    PoseLayout layout;
    const std::size_t nodes = 200'000;
    for (std::size_t n = 0; n < nodes; ++n)
        layout.parents.push_back(n + 1 < nodes ? static_cast<std::int32_t>(n + 1) : -1);
    layout.names.assign(nodes, "n");
    layout.first_weight.assign(nodes + 1, 0);
    std::vector<float> mask(nodes, 0.0f);
    mask_branch(layout, 100'000, 1.0f, mask);
    EXPECT_EQ(std::ranges::count(mask, 1.0f), 100'001);
    EXPECT_EQ(mask[100'000], 1.0f);
    EXPECT_EQ(mask[100'001], 0.0f);
}

} // namespace
} // namespace hachure::animation
