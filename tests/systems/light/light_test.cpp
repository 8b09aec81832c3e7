#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/light_strength.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/transform/transform.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace hachure {
namespace {

class LightTest : public ::testing::Test {
protected:
    LightTest() {
        register_transform(app);
        register_camera(app);
        register_light(app);
    }

    const std::vector<ShadingLight>& lights() {
        app.run_frame();
        return world.resource<LightList>().lights;
    }

    App app;
    World& world = app.world();
};

TEST_F(LightTest, TheDefaultLightComesFromUpAndRightOfTheCamera) {
    spawn_default_light(world);
    const Entity camera = world.create_with(Transform{}, Camera{});
    for (const float turn : {0.0f, 0.5f, 2.0f, 4.0f}) {
        world.get_mutable<Transform>(camera).rotation =
            glm::angleAxis(turn, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f * turn, glm::vec3(1, 0, 0));
        ASSERT_EQ(lights().size(), 1u);
        const View& view = world.resource<View>();
        const ShadingLight& light = lights()[0];
        EXPECT_EQ(light.position.w, 0.0f);
        EXPECT_LT(glm::distance(glm::vec3(light.position), glm::normalize(view.right + view.up)), 1e-6f);
        EXPECT_NEAR(glm::dot(glm::vec3(light.position), view.backward), 0.0f, 1e-6f);
        EXPECT_EQ(light.color, glm::vec3(1.0f));
    }
}

TEST_F(LightTest, AWorldLightShinesAlongItsMinusZWhateverTheCameraDoes) {
    const glm::quat turn = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1, 2, -1)));
    world.create_with(Transform{.translation = {1, 2, 3}, .rotation = turn, .scale = glm::vec3(4.0f)},
                      Light{.kind = LightKind::spot, .range = 7.0f, .inner_cone = 0.1f, .outer_cone = 0.3f});
    world.create_with(Transform{.translation = {9, 9, 9}}, Camera{});
    const ShadingLight light = lights().at(0);
    EXPECT_LT(glm::distance(light.direction, turn * glm::vec3(0, 0, -1)), 1e-6f);
    EXPECT_EQ(light.position, glm::vec4(1, 2, 3, 1));
    EXPECT_TRUE(light.spot);
    EXPECT_EQ(light.range, 7.0f);
    EXPECT_EQ(light.outer_cone, 0.3f);
}

TEST_F(LightTest, DirectionalLightMayTurnWithTheGaze) {
    const Entity light = spawn_default_light(world);
    world.create_with(Transform{.translation = {9, 1, 4}, .rotation = glm::angleAxis(0.7f, glm::vec3(0, 1, 0))},
                      Camera{});
    const ShadingLight on_camera = lights().at(0);
    const std::uint64_t key = world.resource<LightList>().key();
    EXPECT_FALSE(on_camera.gaze);
    world.get_mutable<Light>(light).rig = LightRig::gaze;
    EXPECT_TRUE(lights().at(0).gaze);
    EXPECT_NE(world.resource<LightList>().key(), key);
    EXPECT_EQ(lights()[0].position, on_camera.position) << "on the camera's axis it is the same";
    world.get_mutable<Light>(light).kind = LightKind::point;
    EXPECT_FALSE(lights().at(0).gaze) << "a place has no direction to turn";
}

TEST_F(LightTest, TheStrongestIsFirstAndWhite) {
    world.create_with(Transform{}, Light{.color = {1, 0, 0}, .intensity = 10.0f});
    world.create_with(Transform{}, Light{.color = {0, 1, 0}, .intensity = 40.0f});
    world.create_with(Transform{}, Light{.color = {0, 0, 1}, .intensity = 20.0f});
    const std::vector<ShadingLight>& list = lights();
    ASSERT_EQ(list.size(), 3u);
    EXPECT_EQ(list[0].color, glm::vec3(0, 1, 0));
    EXPECT_EQ(list[1].color, glm::vec3(0, 0, 0.5f));
    EXPECT_EQ(list[2].color, glm::vec3(0.25f, 0, 0));
}

TEST_F(LightTest, HowStrongTheStrongestIsIsToldApart) {
    const Entity sun = world.create_with(Transform{}, Light{.intensity = 500.0f});
    world.create_with(Transform{}, Light{.intensity = 100.0f});
    EXPECT_EQ(lights()[0].color, glm::vec3(1.0f));
    EXPECT_EQ(world.resource<LightStrength>().strongest, 500.0f);
    world.get_mutable<Light>(sun).intensity = 0.0f;
    static_cast<void>(lights());
    EXPECT_EQ(world.resource<LightStrength>().strongest, 100.0f);
}

TEST_F(LightTest, EqualLightsKeepTheOrderInWhichTheyWereMade) {
    for (int i = 0; i < 20; ++i)
        world.create_with(Transform{.translation = {float(i), 0, 0}}, Light{.kind = LightKind::point});
    const std::vector<ShadingLight>& list = lights();
    ASSERT_EQ(list.size(), LightList::max_lights);
    for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i].position.x, float(i));
}

TEST_F(LightTest, DarkAndFlattenedLightsDoNoHarm) {
    world.create_with(Transform{}, Light{.intensity = 0.0f});
    world.create_with(Transform{.scale = glm::vec3(0.0f)}, Light{});
    const std::vector<ShadingLight>& list = lights();
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].color, glm::vec3(0.0f));
}

TEST_F(LightTest, TheKeyFollowsTheLights) {
    const Entity light = world.create_with(Transform{}, Light{.kind = LightKind::point});
    static_cast<void>(lights());
    const std::uint64_t key = world.resource<LightList>().key();
    static_cast<void>(world.get_mutable<Light>(light));
    static_cast<void>(lights());
    EXPECT_EQ(world.resource<LightList>().key(), key);
    world.get_mutable<Transform>(light).translation.x = 1.0f;
    static_cast<void>(lights());
    EXPECT_NE(world.resource<LightList>().key(), key);
}

} // namespace
} // namespace hachure
