// When a surface is deformed on the GPU, and what is drawn of it then.

#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/rig.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/picture_compare.h>
#include <hachure/tests/systems/deform/gpu_shape.h>

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace hachure::test {
namespace {

/// The arm, with a camera that sees it.
struct GpuPassTest : GlTest {
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        scene = std::make_unique<DrawnScene>(context(), Canvas{160, 120});
        arm = spawn_model(world(), arm_model());
        spawn_framing_camera(world(), arm.points, {160, 120});
        spawn_default_light(world());
        world().add(surface(), Gooch{});
        world().add(surface(), Deform{.device = DeformDevice::gpu});
    }
    void TearDown() override {
        scene.reset();
        GlTest::TearDown();
    }

    World& world() { return scene->world(); }
    Entity surface() { return arm.surfaces[0]; }
    bool on_gpu() { return world().get<Deformed>(surface()).on_gpu; }
    void bend(float degrees) {
        world().get_mutable<Transform>(world().get<Rig>(arm.root).nodes[2]).rotation =
            glm::angleAxis(glm::radians(degrees), glm::vec3(0, 0, 1));
    }
    /// Without what is not there.
    std::optional<gpu::PassState> draw_pass() {
        const auto states = scene->draw_passes();
        const auto found = states.find("deform");
        return found == states.end() ? std::nullopt : std::optional(found->second);
    }

    std::unique_ptr<DrawnScene> scene;
    SpawnedModel arm;
};

TEST_P(GpuPassTest, PicturesAreTheSame) {
    bend(70.0f);
    world().get_mutable<MorphWeights>(surface()).values = {0.7f};
    const assets::Image gpu = scene->draw();
    ASSERT_TRUE(on_gpu());
    world().get_mutable<Deform>(surface()).device = DeformDevice::cpu;
    const assets::Image cpu = scene->draw();
    ASSERT_FALSE(on_gpu());
    EXPECT_TRUE(same_driver_gate(gpu, cpu));
    bend(0.0f);
    EXPECT_FALSE(same_driver_gate(gpu, scene->draw())) << "the pose is seen";
}

TEST_P(GpuPassTest, RunsWhenSomethingMoved) {
    bend(20.0f);
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    EXPECT_EQ(draw_pass(), gpu::PassState::reused);
    EXPECT_EQ(world().resource<DeformCounts>().surfaces, 0u);
    bend(30.0f);
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    world().get_mutable<Transform>(arm.root).translation.x = 0.1f;
    EXPECT_EQ(draw_pass(), gpu::PassState::reused) << "the shape is the same";
    world().get_mutable<MorphWeights>(surface()).values = {0.5f};
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    world().get_mutable<Deform>(surface()).method = geometry::SkinMethod::dual_quaternion;
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    world().get_mutable<Deform>(surface()).device = DeformDevice::cpu;
    EXPECT_EQ(draw_pass(), std::nullopt);
}

TEST_P(GpuPassTest, WhatComesBackIntoViewHasItsShape) {
    bend(50.0f);
    const assets::Image before = scene->draw();
    world().get_mutable<Surface>(surface()).visible = false;
    EXPECT_EQ(draw_pass(), std::nullopt);
    world().get_mutable<Surface>(surface()).visible = true;
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    EXPECT_TRUE(same_driver_gate(before, scene->renderer().read_picture()));
}

TEST_P(GpuPassTest, CopiesHaveShapesOfTheirOwn) {
    bend(20.0f);
    scene->draw();
    const Entity copy = world().get<Rig>(world().instantiate(arm.root)).morphs[0];
    bend(60.0f);
    scene->draw();
    const Vertices first = read_back(world(), surface()), second = read_back(world(), copy);
    EXPECT_GT(glm::distance(first.positions.back(), second.positions.back()), 0.3f);
}

TEST_P(GpuPassTest, StaysOnTheCpuForThoseWhoLookAtPositions) {
    bend(20.0f);
    scene->draw();
    EXPECT_TRUE(on_gpu());
    world().add(surface(), EdgeLines{});
    scene->draw();
    EXPECT_FALSE(on_gpu());
    EXPECT_EQ(world().get<Deformed>(surface()).positions.size(), 84u);
    world().remove<EdgeLines>(surface());
    scene->draw();
    EXPECT_TRUE(on_gpu());
    world().add(surface(), ShadeStrokes{.cells = 100});
    scene->draw();
    EXPECT_FALSE(on_gpu());
    world().remove<ShadeStrokes>(surface());
    scene->draw();
    EXPECT_TRUE(on_gpu());
    world().get_mutable<Deform>(surface()).normals = DeformedNormals::recomputed;
    scene->draw();
    EXPECT_FALSE(on_gpu());
    world().get_mutable<Deform>(surface()).normals = DeformedNormals::blended;
    scene->draw();
    EXPECT_TRUE(on_gpu());
    scene->renderer().request_aov("velocity");
    scene->draw();
    EXPECT_FALSE(on_gpu());
}

/// After its shape was left to the GPU.
TEST_P(GpuPassTest, LinesCanComeInTheMiddleOfAFrame) {
    bend(20.0f);
    scene->draw();
    scene->app().add_system(Stage::light, "late lines", [entity = surface(), done = false](Commands& commands) mutable {
        if (!std::exchange(done, true)) commands.add(entity, EdgeLines{});
    });
    bend(30.0f);
    scene->draw();
    EXPECT_TRUE(on_gpu());
    scene->draw();
    EXPECT_FALSE(on_gpu());
    EXPECT_EQ(world().get<Deformed>(surface()).positions.size(), 84u);
}

TEST(DeformDeviceTest, WithoutAGpuTheCpuDoes) {
    App app;
    register_transform(app);
    register_animation(app);
    register_deform(app);
    const SpawnedModel arm = spawn_model(app.world(), arm_model());
    app.world().add(arm.surfaces[0], Deform{.device = DeformDevice::gpu});
    app.run_frame();
    EXPECT_FALSE(app.world().get<Deformed>(arm.surfaces[0]).on_gpu);
    EXPECT_EQ(app.world().get<Deformed>(arm.surfaces[0]).positions.size(), 84u);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(GpuPassTest);

} // namespace
} // namespace hachure::test
