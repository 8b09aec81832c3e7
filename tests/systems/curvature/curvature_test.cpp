#include <hachure/components/curvature.h>
#include <hachure/components/deformed.h>
#include <hachure/components/rig.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/curvature/curvature.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/drawn_scene.h>

#include <gtest/gtest.h>

namespace hachure::test {
namespace {

struct CurvatureTest : ::testing::Test {
    CurvatureTest() {
        register_transform(app);
        register_deform(app);
        register_curvature(app);
    }
    World& world() { return app.world(); }
    const CurvatureCounts& counts() { return world().resource<CurvatureCounts>(); }

    Entity add(const geometry::Shape& shape) {
        const std::uint32_t mesh = world().resource_mutable<MeshStore>().add(surface_mesh(shape));
        return world().create_with(Transform{}, Surface{mesh});
    }

    App app;
};

TEST_F(CurvatureTest, OfASphereIsOneOverItsRadius) {
    const Entity ball = add(geometry::icosphere(0.5, 4));
    app.run_frame();
    EXPECT_FALSE(world().has<PrincipalCurvatures>(ball)) << "nobody asked";
    world().add(ball, Curvature{});
    app.run_frame();
    EXPECT_EQ(counts().recomputed, 1u);
    for (const glm::vec2& curvature : world().get<PrincipalCurvatures>(ball).curvatures) {
        EXPECT_NEAR(curvature.x, 2.0, 0.05);
        EXPECT_NEAR(curvature.y, 2.0, 0.05);
    }
    app.run_frame();
    EXPECT_EQ(counts().recomputed, 0u) << "nothing moved";
    world().remove<Curvature>(ball);
    app.run_frame();
    EXPECT_FALSE(world().has<PrincipalCurvatures>(ball)) << "nobody asks any more";
}

TEST_F(CurvatureTest, FollowsTheShape) {
    const SpawnedModel arm = spawn_model(world(), arm_model());
    const Entity surface = arm.surfaces[0];
    for (const CurvatureSource source : {CurvatureSource::recomputed, CurvatureSource::carried}) {
        world().add(surface, Curvature{source});
        app.run_frame();
        const std::vector<glm::vec3> rest = world().get<PrincipalCurvatures>(surface).directions;
        const Entity shoulder = world().get<Rig>(arm.root).nodes[1];
        world().get_mutable<Transform>(shoulder).rotation *= glm::angleAxis(1.0f, glm::vec3(0, 0, 1));
        app.run_frame();
        const PrincipalCurvatures& turned = world().get<PrincipalCurvatures>(surface);
        EXPECT_EQ(turned.version, world().get<Deformed>(surface).version);
        EXPECT_EQ(counts().carried, source == CurvatureSource::carried ? 1u : 0u);
        EXPECT_EQ(counts().recomputed, source == CurvatureSource::carried ? 0u : 1u);
        // The whole arm turned stiffly: so did the directions, up to their sign.
        const glm::quat turn = glm::angleAxis(1.0f, glm::vec3(0, 0, 1));
        for (std::size_t i = 0; i < rest.size(); ++i)
            EXPECT_NEAR(std::abs(glm::dot(turn * rest[i], turned.directions[i])), 1.0, 1e-3) << i;
    }
}

} // namespace
} // namespace hachure::test
