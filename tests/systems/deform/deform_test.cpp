#include <hachure/components/animation.h>
#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/rig.h>
#include <hachure/components/skin.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/support/arm_model.h>

#include <gtest/gtest.h>

namespace hachure::test {
namespace {

struct DeformTest : ::testing::Test {
    DeformTest() {
        register_transform(app);
        register_animation(app);
        register_deform(app);
        model = spawn_model(app.world(), source);
        app.run_frame();
    }

    World& world() { return app.world(); }
    Entity surface() { return model.surfaces[0]; }
    const Deformed& shape() { return world().get<Deformed>(surface()); }
    std::uint64_t deformed() { return world().resource<DeformCounts>().surfaces; }
    void bend(double degrees) {
        const Rig& rig = world().get<Rig>(model.root);
        world().get_mutable<Transform>(rig.nodes[2]).rotation =
            glm::quat(glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 0, 1)));
        app.run_frame();
    }

    /// Linear blend skinning, from the formula.
    glm::dvec3 bent(std::size_t vertex, double degrees) const {
        const assets::Primitive& arm = source.meshes[0].primitives[0];
        const glm::dvec3 rest(arm.positions[vertex]);
        const double angle = glm::radians(degrees), elbow = arm.weights[0][vertex].y;
        const glm::dvec3 above = rest - glm::dvec3(0, 1, 0);
        const glm::dvec3 turned(std::cos(angle) * above.x - std::sin(angle) * above.y,
                                1.0 + std::sin(angle) * above.x + std::cos(angle) * above.y, above.z);
        return (1.0 - elbow) * rest + elbow * turned;
    }

    assets::Model source = arm_model();
    App app;
    SpawnedModel model;
};

TEST_F(DeformTest, AtRestTheShapeIsTheMeshs) {
    const assets::Primitive& arm = source.meshes[0].primitives[0];
    ASSERT_EQ(shape().positions.size(), arm.positions.size());
    for (std::size_t i = 0; i < arm.positions.size(); ++i)
        EXPECT_LT(glm::distance(shape().positions[i], arm.positions[i]), 1e-6f);
}

TEST_F(DeformTest, FollowsItsJoints) {
    bend(70.0);
    for (std::size_t i = 0; i < shape().positions.size(); ++i)
        EXPECT_LT(glm::distance(glm::dvec3(shape().positions[i]), bent(i, 70.0)), 2e-6) << i;
    EXPECT_EQ(deformed(), 1u);
}

TEST_F(DeformTest, BoundsFollow) {
    bend(90.0);
    const geometry::Bounds around = geometry::bounds_of(shape().positions);
    EXPECT_EQ(shape().bounds.low, around.low);
    EXPECT_EQ(shape().bounds.high, around.high);
    EXPECT_NEAR(shape().bounds.low.x, -1.0, 1e-5);
    EXPECT_LT(shape().bounds.high.y, 1.3f);
}

TEST_F(DeformTest, WhatStandsStillCostsNothing) {
    bend(30.0);
    const std::uint64_t version = shape().version;
    app.run_frame();
    EXPECT_EQ(deformed(), 0u);
    world().get_mutable<Transform>(model.root).translation = {0.5f, 0.25f, 1.0f};
    app.run_frame();
    EXPECT_EQ(deformed(), 0u) << "the whole model moved, its shape did not change";
    EXPECT_EQ(shape().version, version);
}

TEST_F(DeformTest, MorphsBeforeItSkins) {
    world().get_mutable<MorphWeights>(surface()).values = {0.5f};
    bend(0.0);
    for (const glm::vec3& position : shape().positions)
        EXPECT_NEAR(glm::length(glm::vec2(position.x, position.z)), 0.25, 1e-6);
    bend(90.0);
    EXPECT_NEAR(shape().positions.back().z, -0.25, 1e-5) << "the last vertex lies across the plane of the bend";
}

TEST_F(DeformTest, DualQuaternionsKeepTheRadius) {
    const auto thinnest = [&] {
        double least = 1.0;
        // The sides at right angles to the bend, where nothing but a collapse moves a vertex off its distance.
        for (std::size_t i = 0; i < shape().positions.size(); i += 4) {
            const glm::dvec3 middle = 0.25 * glm::dvec3(shape().positions[i] + shape().positions[i + 1] +
                                                        shape().positions[i + 2] + shape().positions[i + 3]);
            least = std::min(least, glm::distance(glm::dvec3(shape().positions[i]), middle));
        }
        return least;
    };
    bend(120.0);
    const double linear = thinnest();
    world().get_mutable<Deform>(surface()).method = geometry::SkinMethod::dual_quaternion;
    app.run_frame();
    EXPECT_EQ(deformed(), 1u);
    EXPECT_NEAR(linear, 0.1, 0.01) << "cos 60 degrees of .2 m";
    EXPECT_NEAR(thinnest(), 0.2, 0.002);
}

TEST_F(DeformTest, NormalsCanBeRecomputed) {
    bend(60.0);
    const std::vector<glm::vec3> blended = shape().normals;
    world().get_mutable<Deform>(surface()).normals = DeformedNormals::recomputed;
    app.run_frame();
    double largest = 0.0;
    for (std::size_t i = 0; i < blended.size(); ++i) {
        EXPECT_NEAR(glm::length(shape().normals[i]), 1.0, 1e-5);
        largest = std::max<double>(largest, glm::distance(blended[i], shape().normals[i]));
    }
    EXPECT_GT(largest, 0.05) << "blended normals are wrong in the bend";
}

TEST_F(DeformTest, CopiesHaveShapesOfTheirOwn) {
    bend(20.0);
    const Entity copy = world().instantiate(model.root);
    const Entity copied = world().get<Rig>(copy).morphs[0];
    EXPECT_NE(copied, surface());
    world().get_mutable<Transform>(world().get<Rig>(copy).nodes[2]).rotation =
        glm::angleAxis(glm::radians(80.0f), glm::vec3(0, 0, 1));
    app.run_frame();
    const Deformed& other = world().get<Deformed>(copied);
    EXPECT_NE(other.version, shape().version);
    for (std::size_t i = 0; i < other.positions.size(); ++i) {
        EXPECT_LT(glm::distance(glm::dvec3(other.positions[i]), bent(i, 80.0)), 2e-6) << i;
        EXPECT_LT(glm::distance(glm::dvec3(shape().positions[i]), bent(i, 20.0)), 2e-6) << i;
    }
}

TEST_F(DeformTest, AFlattenedModelHasAShapeAllTheSame) {
    world().get_mutable<Transform>(model.root).scale = {1.0f, 0.0f, 1.0f};
    bend(45.0);
    for (const glm::vec3& position : shape().positions) EXPECT_TRUE(std::isfinite(glm::dot(position, position)));
    for (const glm::vec3& normal : shape().normals) EXPECT_NEAR(glm::length(normal), 1.0, 1e-5);
}

TEST_F(DeformTest, AMissingJointStandsWhereItWas) {
    world().destroy(world().get<Rig>(model.root).nodes[2]);
    world().get_mutable<Transform>(model.root).translation.x = 1.0f;
    app.run_frame();
    const assets::Primitive& arm = source.meshes[0].primitives[0];
    for (std::size_t i = 0; i < arm.positions.size(); ++i)
        EXPECT_LT(glm::distance(shape().positions[i], arm.positions[i]), 1e-6f);
}

TEST_F(DeformTest, ASkinThatDoesNotFitItsMeshIsLeftAlone) {
    bend(10.0);
    world().get_mutable<Skin>(surface()).joints.pop_back();
    bend(30.0);
    for (const glm::vec3& position : shape().positions) EXPECT_TRUE(std::isfinite(glm::dot(position, position)));
}

} // namespace
} // namespace hachure::test
