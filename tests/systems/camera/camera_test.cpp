#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/transform/transform.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hachure {
namespace {

glm::vec3 ndc(const View& view, const glm::vec3& world) {
    const glm::vec4 c = view.clip_from_world * glm::vec4(world, 1.0f);
    return glm::vec3(c) / c.w;
}

TEST(MakeView, DepthIsOneAtTheNearPlaneAndZeroAtTheFarOne) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera{.projection = projection, .znear = 0.5f, .zfar = 20.0f};
        const View view = make_view(camera, glm::mat4(1.0f), {400, 300});
        EXPECT_NEAR(ndc(view, {0, 0, -0.5f}).z, 1.0f, 1e-6);
        EXPECT_NEAR(ndc(view, {0, 0, -20.0f}).z, 0.0f, 1e-6);
        EXPECT_GT(ndc(view, {0, 0, -3.0f}).z, ndc(view, {0, 0, -4.0f}).z);
    }
}

TEST(MakeView, WithoutAFarPlanePerspectiveDepthIsNearOverDistance) {
    const View view = make_view(Camera{.znear = 0.25f}, glm::mat4(1.0f), {400, 300});
    for (const float z : {0.25f, 1.0f, 10.0f, 1e4f, 1e8f}) EXPECT_NEAR(ndc(view, {0, 0, -z}).z * z, 0.25f, 1e-6);
}

/// Depth in a 32-bit float has to tell a pixel's width apart, or lines flicker through surfaces.
TEST(MakeView, OrthographicDepthIsFinerThanAPixelWithoutAFarPlane) {
    const View view =
        make_view(Camera{.projection = Projection::orthographic, .ymag = 2.0f}, glm::mat4(1.0f), {1024, 768});
    for (const float z : {0.1f, 3.0f, 20.0f, 100.0f}) {
        const float step = 0.1f * view.pixel_size;
        EXPECT_GT(ndc(view, {0, 0, -z}).z, ndc(view, {0, 0, -z - step}).z) << "at " << z;
        EXPECT_GT(ndc(view, {0, 0, -z}).z, 0.0f);
    }
}

TEST(MakeView, TheEdgesOfTheViewAreWhereTheCameraSays) {
    const View perspective = make_view(Camera{.yfov = 1.0f}, glm::mat4(1.0f), {400, 300});
    const float slope = std::tan(0.5f);
    EXPECT_NEAR(ndc(perspective, {0, 5 * slope, -5}).y, 1.0f, 1e-6);
    EXPECT_NEAR(ndc(perspective, {-5 * slope * 4 / 3, 0, -5}).x, -1.0f, 1e-6);
    EXPECT_NEAR(perspective.pixel_size, 2 * slope / 300, 1e-7);
    const View orthographic =
        make_view(Camera{.projection = Projection::orthographic, .ymag = 1.5f}, glm::mat4(1.0f), {400, 300});
    EXPECT_NEAR(ndc(orthographic, {2.0f, -1.5f, -7}).x, 1.0f, 1e-6);
    EXPECT_NEAR(ndc(orthographic, {2.0f, -1.5f, -7}).y, -1.0f, 1e-6);
    EXPECT_NEAR(orthographic.pixel_size, 0.01f, 1e-7);
}

TEST(MakeView, TheScaleOfTheCamerasEntityIsIgnored) {
    const glm::mat4 pose =
        glm::rotate(glm::translate(glm::mat4(1.0f), {1, 2, 3}), 0.7f, glm::normalize(glm::vec3(1, 2, 2)));
    const View plain = make_view(Camera{}, pose, {64, 64});
    const View scaled = make_view(Camera{}, glm::scale(pose, {3, 0.2f, 5}), {64, 64});
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(plain.clip_from_world[i], scaled.clip_from_world[i]), 1e-5f);
}

TEST(MakeView, ADegenerateCameraGivesFiniteMatrices) {
    const View view = make_view(Camera{}, glm::mat4(0.0f), {0, 0});
    EXPECT_EQ(view.width, 1);
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) EXPECT_TRUE(std::isfinite(view.clip_from_world[i][k]));
}

class FramingTest : public ::testing::Test {
protected:
    FramingTest() {
        register_transform(app);
        register_camera(app);
    }

    /// Frames the points; checks that all are in view, in front of the near plane, and that they fill it.
    void expect_tight(const std::vector<glm::vec3>& points, Canvas canvas) {
        World& world = app.world();
        world.set_resource(canvas);
        const Entity camera = spawn_framing_camera(world, points, canvas);
        app.run_frame();
        const View& view = world.resource<View>();
        ASSERT_EQ(view.camera, camera);
        glm::vec2 low(1e9f), high(-1e9f);
        for (const glm::vec3& point : points) {
            const glm::vec3 p = ndc(view, point);
            low = glm::min(low, glm::vec2(p));
            high = glm::max(high, glm::vec2(p));
            ASSERT_GT(p.z, 0.0f);
            ASSERT_LT(p.z, 1.0f);
        }
        EXPECT_GE(std::min(low.x, low.y), -1.0f);
        EXPECT_LE(std::max(high.x, high.y), 1.0f);
        const glm::vec2 filled = 0.5f * (high - low);
        EXPECT_GT(std::max(filled.x, filled.y), 0.9f);
        EXPECT_LT(std::max(filled.x, filled.y), 0.95f); // a margin of 8 %
        // In the tight direction the picture is centred.
        const int axis = filled.x > filled.y ? 0 : 1;
        EXPECT_NEAR(low[axis], -high[axis], 0.02f);
        world.destroy(camera);
    }

    App app;
};

TEST_F(FramingTest, SeesEveryPointAndFillsTheView) {
    std::mt19937 random(9);
    std::normal_distribution<float> normal;
    for (const Canvas canvas : {Canvas{1024, 768}, Canvas{300, 900}, Canvas{900, 100}})
        for (const float size : {1e-3f, 1.0f, 1e4f}) {
            const glm::vec3 stretch = size * glm::vec3(1.0f, 0.3f + std::abs(normal(random)), 0.5f);
            std::vector<glm::vec3> points;
            for (int i = 0; i < 300; ++i)
                points.push_back(size * glm::vec3(5, -3, 2) +
                                 stretch * glm::vec3(normal(random), normal(random), normal(random)));
            expect_tight(points, canvas);
            expect_tight(geometry::icosphere(double(size), 3).positions, canvas);
        }
}

TEST_F(FramingTest, OnePointAndAFlatMeshHaveAUsableView) {
    World& world = app.world();
    for (const std::vector<glm::vec3>& points :
         {std::vector<glm::vec3>{{4, 5, 6}}, std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}}) {
        const Entity camera = spawn_framing_camera(world, points, {64, 48});
        app.run_frame();
        for (const glm::vec3& point : points) {
            const glm::vec3 p = ndc(world.resource<View>(), point);
            EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), p.z}), 1.0f);
            EXPECT_GT(p.z, 0.0f);
        }
        world.destroy(camera);
    }
}

TEST_F(FramingTest, TheFirstActiveCameraDraws) {
    World& world = app.world();
    const Entity first = world.create_with(Transform{}, Camera{.active = false});
    const Entity second = world.create_with(Transform{}, Camera{}), third = world.create_with(Transform{}, Camera{});
    app.run_frame();
    EXPECT_EQ(world.resource<View>().camera, second);
    world.get_mutable<Camera>(first).active = true;
    app.run_frame();
    EXPECT_EQ(world.resource<View>().camera, first);
    world.destroy(first);
    world.destroy(second);
    app.run_frame();
    EXPECT_EQ(world.resource<View>().camera, third);
}

} // namespace
} // namespace hachure
