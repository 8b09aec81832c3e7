#include <hachure/components/animation.h>
#include <hachure/components/rig.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hachure::test {
namespace {

constexpr Canvas canvas{200, 100};

/// An orthographic view of 2 m height: 50 pixels per metre.
struct VelocityTest : ::testing::Test {
    void SetUp() override {
        std::string reason;
        gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
        if (!context) GTEST_SKIP() << "no EGL context: " << reason;
        scene = std::make_unique<DrawnScene>(*context, canvas);
        scene->add(Camera{.projection = Projection::orthographic, .ymag = 1.0f}, {.translation = {0, 0, 5}});
        scene->renderer().request_aov("velocity");
    }

    glm::vec2 velocity(int x, int y) {
        const assets::Image image = scene->renderer().read_aov("velocity");
        const float* pixel = image.f32() + 2 * (y * canvas.width + x);
        return {pixel[0], pixel[1]};
    }
    gpu::PassState draw() { return scene->draw_passes().at("velocity"); }

    std::unique_ptr<DrawnScene> scene;
};

TEST_F(VelocityTest, FollowsTransforms) {
    const Entity ball = scene->add(surface_mesh(geometry::icosphere(0.5, 3)));
    draw();
    EXPECT_EQ(velocity(100, 50), glm::vec2(0.0f)) << "nothing has moved in the first frame";
    scene->world().get_mutable<Transform>(ball).translation = {0.1f, 0.04f, 0.0f};
    draw();
    EXPECT_NEAR(velocity(100, 50).x, 5.0, 1e-3);
    EXPECT_NEAR(velocity(100, 50).y, 2.0, 1e-3);
    EXPECT_EQ(velocity(5, 5), glm::vec2(0.0f)) << "nothing is drawn there";
}

TEST_F(VelocityTest, ComesToRestAndThenCostsNothing) {
    const Entity ball = scene->add(surface_mesh(geometry::icosphere(0.5, 3)));
    draw();
    scene->world().get_mutable<Transform>(ball).translation.x = 0.1f;
    draw();
    EXPECT_EQ(draw(), gpu::PassState::run);
    EXPECT_EQ(velocity(100, 50), glm::vec2(0.0f));
    EXPECT_EQ(draw(), gpu::PassState::reused);
}

TEST_F(VelocityTest, FollowsTheCamera) {
    scene->add(surface_mesh(geometry::icosphere(0.5, 3)));
    draw();
    const Entity camera = scene->world().query<const Camera>().first();
    scene->world().get_mutable<Transform>(camera).translation.x = 0.2f;
    draw();
    EXPECT_NEAR(velocity(100, 50).x, -10.0, 1e-3);
}

TEST_F(VelocityTest, FollowsDeformation) {
    const SpawnedModel arm = spawn_model(scene->world(), arm_model());
    scene->world().get_mutable<Transform>(arm.root).translation = {0.0f, -1.0f, 0.0f};
    draw();
    const Rig& rig = scene->world().get<Rig>(arm.root);
    const float angle = 0.05f;
    scene->world().get_mutable<Transform>(rig.nodes[2]).rotation = glm::angleAxis(angle, glm::vec3(0, 0, 1));
    draw();
    // Near the tip, .9 m above the elbow, which is in the middle of the picture.
    const glm::dvec2 before(0.0, 0.9);
    const glm::dvec2 now(-std::sin(angle) * before.y, std::cos(angle) * before.y);
    const auto x = static_cast<int>(100.0 + 50.0 * now.x), y = static_cast<int>(50.0 - 50.0 * now.y);
    const glm::vec2 tip = velocity(x, y);
    EXPECT_NEAR(tip.x, 50.0 * (now.x - before.x), 0.15);
    EXPECT_NEAR(tip.y, 50.0 * (now.y - before.y), 0.15);
    EXPECT_EQ(velocity(100, 90), glm::vec2(0.0f)) << "the shoulder stands still";
}

} // namespace
} // namespace hachure::test
